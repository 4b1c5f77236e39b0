// What a student has done, between runs of the program:
//
//   {"format": "anamorph-progress", "version": 1, "lessons": {"plane": ["aside", "vertex"], ...}}
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "edit/lesson_state.h"

namespace anamorph {

std::filesystem::path progressPath();

/// Without a file: nothing done yet. A broken one too, with what is wrong in `message`.
LessonProgress loadProgress(const std::filesystem::path& path, std::string& message);

/// Adds to what the file has, which another window may have written, and replaces it atomically; no progress at
/// all replaces it by nothing. A broken file is first set aside, as progress.json.broken. Makes the folder.
/// Returns what could not be kept of the old one. Throws Error.
std::vector<std::string> saveProgress(const std::filesystem::path& path, LessonProgress progress);

}  // namespace anamorph
