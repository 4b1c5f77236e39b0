// The levels that are installed with the program: the .json files in the folder `levels` of the resources, in the order in
// which they are learnt from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "level/lesson.h"

namespace anamorph {

struct LevelEntry {
  std::filesystem::path path;
  std::string name;     ///< the file's name without ending, "1-plane"
  const char* group;    ///< the heading that it is listed under, English: "First steps"
  std::string title;    ///< empty when the level cannot be read
  std::string problem;  ///< what loadLevel says then; empty when all is well
  Lesson lesson;
};

/// The folder of the installed levels. Throws Error when there is none.
std::filesystem::path levelFolder();

/// The levels in a folder: by the number before their name, those without one last.
std::vector<LevelEntry> listLevels(const std::filesystem::path& folder = levelFolder());

/// The file that a user means: one that exists, or an installed level by its name ("1-plane"), the number
/// before its name ("1") or the name after the number ("plane"). Anything that looks like a path comes back
/// as it is. Throws Error that lists the installed levels.
std::filesystem::path findLevel(const std::string& nameOrPath);

}  // namespace anamorph
