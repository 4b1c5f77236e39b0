// What a student has done, between runs of the program:
//
//   {"format": "anamorph-progress", "version": 1, "lessons": {"plane": ["aside", "vertex"], ...}}
#pragma once

#include <filesystem>
#include <string>

#include "edit/lesson_run.h"

namespace anamorph {

std::filesystem::path progressPath();

/// Without a file: nothing done yet. A broken one too, with what is wrong in `message`; it is kept beside the
/// new one under the name progress.json.broken.
LessonProgress loadProgress(const std::filesystem::path& path, std::string& message);

/// Replaces the file atomically, and makes its folder. Throws Error.
void saveProgress(const std::filesystem::path& path, const LessonProgress& progress);

}  // namespace anamorph
