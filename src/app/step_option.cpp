#include "app/step_option.h"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/text.h"
#include "cli/usage_error.h"

namespace anamorph {

void addStepOption(CLI::App& command, std::optional<std::size_t>& step, const char* help) {
  command.add_option("--step", step, help);
}

void checkStep(const std::optional<std::size_t>& step, const Lesson& lesson) {
  if (!step || (*step >= 1 && *step <= lesson.steps.size())) return;
  if (lesson.steps.empty()) throw UsageError("--step: this level has no lesson");
  std::vector<std::string> names;
  for (const LessonStep& each : lesson.steps) {
    names.push_back(fmt::format("{} ({})", names.size() + 1, each.title));
  }
  throw UsageError(fmt::format("--step: expected {}, got {}", alternatives(names), *step));
}

}  // namespace anamorph
