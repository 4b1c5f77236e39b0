#include "edit/replacements.h"

#include <cmath>
#include <utility>

#include "edit/level_edits.h"
#include "level/freeze.h"
#include "level/limits.h"
#include "pipeline/original.h"

namespace anamorph {
namespace {

// Whether the shape has a size of its own that took the factor.
struct Resize {
  double factor;

  bool operator()(BoxShape& s) const {
    s.size *= factor;
    return true;
  }
  bool operator()(SphereShape& s) const {
    s.radius *= factor;
    return true;
  }
  bool operator()(LetterFShape& s) const {
    s.height *= factor;
    return true;
  }
  bool operator()(PawnShape& s) const {
    s.height *= factor;
    return true;
  }
  bool operator()(TorusKnotShape&) const { return false; }
  bool operator()(FileShape&) const { return false; }
};

}  // namespace

double scaleInto(const Box& own, const Box& room) {
  const double factor = factorInto(own, room);
  return limits::lengths.holds(factor) ? factor : 1;
}

OriginalShape builtInShape(std::size_t kind) {
  switch (kind) {
    case 1:
      return SphereShape{};
    case 2:
      return TorusKnotShape{};
    case 3:
      return LetterFShape{};
    case 4:
      return PawnShape{};
    default:
      return BoxShape{};
  }
}

Level withOriginal(const Level& level, OriginalShape shape, const Mesh& mesh, const Box& box) {
  Level result = following(level);  // what is frozen was the old one's
  OriginalSettings& original = result.original;
  const Box own = boundingBox(mesh.positions);
  original.unitize = false;
  original.placement.rotationDegrees = Vector(0);
  original.placement.scale = Vector(1);
  if (!own.empty() && !box.empty()) {
    const double factor = scaleInto(own, box);
    original.placement.position = clampedPoint(box.centre() - factor * own.centre());
    if (!std::visit(Resize{factor}, shape)) original.placement.scale = Vector(factor);
  }
  original.shape = std::move(shape);
  return result;
}

Level withAnotherMesh(const Level& level, FileShape file, const Mesh& mesh, const Box& box) {
  Level result = following(level);  // what is frozen was the old one's
  result.original.shape = std::move(file);
  Placement& placement = result.original.placement;
  Placement unmoved = placement;
  unmoved.position = Point(0);
  const Box own = boundingBox(placeOriginal(mesh, level.original.unitize, unmoved)->positions);
  if (own.empty() || box.empty()) return result;
  const double fitting = factorInto(own, box);
  const double factor = fitting >= 0.5 && fitting <= 2 ? 1 : fitting;
  placement.scale =
      glm::clamp(factor * placement.scale, Vector(limits::lengths.min), Vector(limits::lengths.max));
  placement.position = clampedPoint(box.centre() - factor * own.centre());
  return result;
}

Level withBuiltInOriginal(const Level& level, std::size_t kind, const Box& box) {
  OriginalShape shape = builtInShape(kind);
  if (auto* filling = std::get_if<BoxShape>(&shape); filling && !box.empty()) {
    filling->size = glm::clamp(box.size(), Vector(limits::lengths.min), Vector(limits::lengths.max));
  }
  const auto mesh = loadOriginal(shape, {}).mesh;
  return withOriginal(level, std::move(shape), *mesh, box);
}

Box roomInSight(const Level& level) {
  const Camera& camera = level.camera;
  const double distance = glm::length(camera.target - camera.eye);
  const Vector half(0.5 * distance * std::tan(0.5 * radians(camera.fovDegrees)));
  return {camera.target - half, camera.target + half};
}

Level withStandIn(const Level& level) {
  return withBuiltInOriginal(level, OriginalShape(PawnShape()).index(), roomInSight(level));
}

}  // namespace anamorph
