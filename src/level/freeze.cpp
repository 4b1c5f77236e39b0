#include "level/freeze.h"

#include <utility>

namespace anamorph {

SculptureInputs sculptureInputs(const LevelScene& level) {
  if (level.sculpture.frozen) return *level.sculpture.frozen;
  return {level.optic,
          level.camera,
          level.original.unitize,
          level.original.placement,
          level.sculpture.depthScale,
          level.sculpture.depthOffset,
          level.sculpture.mistakes};
}

bool hasOriginalMoved(const LevelScene& level) {
  const auto& kept = level.sculpture.frozen;
  return kept && !(kept->unitize == level.original.unitize && kept->placement == level.original.placement);
}

Level asMade(Level level) {
  const SculptureInputs inputs = sculptureInputs(level);
  level.optic = inputs.optic;
  level.camera = inputs.camera;
  level.original.unitize = inputs.unitize;
  level.original.placement = inputs.placement;
  level.sculpture.depthScale = inputs.depthScale;
  level.sculpture.depthOffset = inputs.depthOffset;
  level.sculpture.mistakes = inputs.mistakes;
  return following(std::move(level));
}

Level frozen(Level level) {
  level.sculpture.frozen = sculptureInputs(level);
  return level;
}

Level following(Level level) {
  level.sculpture.frozen.reset();
  return level;
}

}  // namespace anamorph
