// --step: the step of a level's lesson that is open, for the window and for pictures of it.
#pragma once

#include <cstddef>
#include <optional>

#include <CLI/CLI.hpp>

#include "level/lesson.h"

namespace anamorph {

/// From 1 on; `step` lives as long as the command.
void addStepOption(CLI::App& command, std::optional<std::size_t>& step, const char* help);

/// Throws UsageError that lists the steps when the lesson has not got this one.
void checkStep(const std::optional<std::size_t>& step, const Lesson& lesson);

}  // namespace anamorph
