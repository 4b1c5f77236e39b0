#include "edit/model_turns.h"

#include <array>
#include <cmath>
#include <numbers>

#include <glm/matrix.hpp>

#include "edit/level_edits.h"
#include "edit/selection.h"

namespace anamorph {
namespace {

constexpr Selection original{Part::original, 0};

// Half the height of a box that was turned about its middle.
double halfHeightTurned(const Box& box, const glm::dmat3& turn) {
  const Vector half = 0.5 * box.size();
  return std::abs(turn[0].z) * half.x + std::abs(turn[1].z) * half.y + std::abs(turn[2].z) * half.z;
}

// A level whose original was turned about the middle of its box, with the lower side where it was.
Level standingAsBefore(const Level& turnedLevel, const Box& box, const glm::dmat3& turn) {
  return moved(turnedLevel, original, {0, 0, halfHeightTurned(box, turn) - 0.5 * box.size().z});
}

}  // namespace

Level turnedQuarter(const Level& level, int axis, const Box& box) {
  if (box.empty()) return level;
  const auto index = static_cast<std::size_t>(axis);
  const Level turnedLevel =
      rotated(level, original, box.centre(), sceneAxes.at(index), 0.5 * std::numbers::pi);
  glm::dmat3 turn(0);  // but for signs, which a box does not feel
  turn[axis][axis] = 1;
  turn[(axis + 1) % 3][(axis + 2) % 3] = turn[(axis + 2) % 3][(axis + 1) % 3] = 1;
  return standingAsBefore(turnedLevel, box, turn);
}

Level withModelUp(const Level& level, ModelUp up, const Box& box) {
  Level result = level;
  auto* file = std::get_if<FileShape>(&result.original.shape);
  if (!file || box.empty()) return result;
  const glm::dmat3 turn = uprightRotation(up) * glm::transpose(uprightRotation(file->up));
  Placement& placement = result.original.placement;
  const glm::dmat3 rotation = rotationMatrix(placement.rotationDegrees);
  // The model's point in the middle of the box stays there; it may be far from the model's origin.
  const Vector middle = glm::transpose(rotation) * (box.centre() - placement.position) / placement.scale;
  placement.position = clampedPoint(box.centre() - rotation * (placement.scale * (turn * middle)));
  file->up = up;
  return standingAsBefore(result, box, rotation * turn * glm::transpose(rotation));
}

ModelUp nextModelUp(ModelUp up) {
  return static_cast<ModelUp>((static_cast<std::size_t>(up) + 1) % modelUpNames.size());
}

}  // namespace anamorph
