#include "edit/model_turns.h"

#include <numbers>

#include <glm/matrix.hpp>

#include "edit/level_edits.h"
#include "edit/selection.h"

namespace anamorph {
namespace {

constexpr Selection original{Part::original, 0};

// A level whose original was turned about the middle of its box, with its lowest point as high as it was.
Level standingAsBefore(const Level& turnedLevel, const Mesh& placed, const glm::dmat3& turn) {
  const Box box = boundingBox(placed.positions);
  const auto turned = [&](const Point& p) { return box.centre() + turn * (p - box.centre()); };
  const Box now = boundingBox(mapPoints(placed.positions, turned));
  return moved(turnedLevel, original, {0, 0, box.min.z - now.min.z});
}

glm::dmat3 scaling(const Vector& factors) {
  return {{factors.x, 0, 0}, {0, factors.y, 0}, {0, 0, factors.z}};
}

}  // namespace

Level turnedQuarter(const Level& level, int axis, const Mesh& placed) {
  if (placed.positions.empty()) return level;
  const Level turnedLevel = rotated(level, original, boundingBox(placed.positions).centre(),
                                    sceneAxes.at(static_cast<std::size_t>(axis)), 0.5 * std::numbers::pi);
  Vector degrees(0);
  degrees[axis] = 90;
  return standingAsBefore(turnedLevel, placed, rotationMatrix(degrees));
}

Level withModelUp(const Level& level, ModelUp up, const Mesh& placed) {
  Level result = level;
  auto* file = std::get_if<FileShape>(&result.original.shape);
  if (!file || placed.positions.empty()) return result;
  const Point centre = boundingBox(placed.positions).centre();
  Placement& placement = result.original.placement;
  const glm::dmat3 rotation = rotationMatrix(placement.rotationDegrees);
  const glm::dmat3 turn = rotation * scaling(placement.scale) * uprightRotation(up) *
                          glm::transpose(uprightRotation(file->up)) * scaling(1.0 / placement.scale) *
                          glm::transpose(rotation);
  // The model's own origin, about which it is turned, may be far from it.
  placement.position = clampedPoint(centre + turn * (placement.position - centre));
  file->up = up;
  return standingAsBefore(result, placed, turn);
}

ModelUp nextModelUp(ModelUp up) {
  return static_cast<ModelUp>((static_cast<std::size_t>(up) + 1) % modelUpNames.size());
}

}  // namespace anamorph
