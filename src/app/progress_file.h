// What a student has done, between runs of the program:
//
//   {"format": "anamorph-progress", "version": 1, "lessons": {"plane": ["aside", "vertex"], ...}}
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "edit/lesson_state.h"

namespace anamorph {

/// Without a file: nothing done yet. A broken one too, with what is wrong in `message`.
LessonProgress loadProgress(const std::filesystem::path& path, std::string& message);

/// Adds what is in `now` and was not in `before` to what the file has, which another window may have written meanwhile,
/// and replaces it atomically; no progress at all replaces it by nothing. Where there is no file, all of `now` is
/// written; so it is in place of a broken one, which is first set aside as progress.json.broken. Makes the folder.
/// Returns what could not be kept of the old one. Throws Error.
std::vector<std::string> saveProgress(const std::filesystem::path& path, const LessonProgress& before,
                                      const LessonProgress& now);

}  // namespace anamorph
