#include "level/move_numbers.h"

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "level/mirror_kind.h"
#include "optics/shape_table.h"

namespace anamorph {
namespace {

std::size_t kindOf(const std::string& name) {
  const std::vector<const char*> names = shapeNames();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

}  // namespace

void setSwitches(LevelScene& level, const StepMove& move) {
  if (!move.mirrorKind.empty()) {
    level.optic.shape() = mirrorOfKind(kindOf(move.mirrorKind), level.optic.shape(), level.camera.eye);
  }
  if (move.tolerancePixels) level.sculpture.tolerancePixels = *move.tolerancePixels;
  auto* box = std::get_if<BoxShape>(&level.original.shape);
  if (box && move.segments) box->segments = *move.segments;
  for (const std::string& mistake : move.putRight) mistakeOf(level.sculpture.mistakes, mistake) = false;
}

void setNumbers(LevelScene& level, const StepMove& move, double part) {
  const auto towards = [&](auto& value, const auto& goal) {
    if (goal) value = glm::mix(value, *goal, part);
  };
  towards(level.camera.eye, move.eye);
  towards(level.original.placement.position, move.original);
  towards(level.sculpture.depthScale, move.depthScale);
  towards(level.sculpture.depthOffset, move.depthOffset);
  towards(level.camera.fovDegrees, move.fovDegrees);
}

}  // namespace anamorph
