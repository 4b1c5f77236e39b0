// The installed levels, finished once for all tests of a program.
#pragma once

#include <map>
#include <string>

#include "level/level_json.h"
#include "pipeline/evaluator.h"
#include "pipeline/original.h"
#include "pipeline/picture.h"

namespace anamorph::testing {

inline LevelResult finish(const Level& level) {
  const auto shape = loadOriginal(level.original.shape, "").mesh;
  return *finishLevel(level, placeOriginal(*shape, level.original.unitize, level.original.placement), 0);
}

inline const LevelResult& finishedLevel(const std::string& name) {
  static std::map<std::string, LevelResult> levels;
  const auto found = levels.find(name);
  if (found != levels.end()) return found->second;
  const Level level = loadLevel(std::string(ANAMORPH_LEVELS) + "/" + name + ".json").level;
  return levels.emplace(name, finish(level)).first->second;
}

}  // namespace anamorph::testing
