#include "edit/replacements.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "edit/level_edits.h"
#include "level/limits.h"
#include "math/frame.h"
#include "pipeline/original.h"

namespace anamorph {
namespace {

// What the kinds have in common: a middle, a way up, a width and a height.
struct Extent {
  Point middle{0};
  Direction up{0, 0, 1};
  double width = 6, height = 6;
};

struct ExtentOf {
  Extent operator()(const PlaneMirror& plane) const {
    const auto& v = plane.corners;
    const Vector across = 0.5 * (v[1] - v[0] + v[2] - v[3]), along = 0.5 * (v[3] - v[0] + v[2] - v[1]);
    // The side that is more upright is the height.
    const bool turned = std::abs(glm::normalize(across).z) > std::abs(glm::normalize(along).z);
    const Vector up = turned ? across : along, side = turned ? along : across;
    return {middleOf(plane), glm::normalize(up.z < 0 ? -up : up), glm::length(side), glm::length(up)};
  }
  Extent operator()(const CylinderMirror& cylinder) const {
    const Vector axis = cylinder.top - cylinder.bottom;
    return {middleOf(cylinder), glm::normalize(axis), 2 * cylinder.radius, glm::length(axis)};
  }
  Extent operator()(const SphereMirror& sphere) const {
    return {sphere.centre, {0, 0, 1}, 2 * sphere.radius, 2 * sphere.radius};
  }
};

Extent extentOf(const MirrorShape& shape) {
  Extent extent;
  if (!findShapeProblem(shape)) return std::visit(ExtentOf{}, shape);
  extent.middle = middleOf(shape);
  if (!isFinite(extent.middle)) extent.middle = Point(0);
  return extent;
}

PlaneMirror planeOf(const Extent& e, const Point& eye) {
  const Vector towards = eye - e.middle, flat = towards - glm::dot(towards, e.up) * e.up;
  const Direction normal = glm::length(flat) > 1e-9 ? glm::normalize(flat) : perpendicular(e.up);
  const Vector x = 0.5 * e.width * glm::cross(e.up, normal), y = 0.5 * e.height * e.up;
  return {{e.middle - x - y, e.middle + x - y, e.middle + x + y, e.middle - x + y}};
}

CylinderMirror cylinderOf(const Extent& e, const Point& eye) {
  const Vector towards = eye - e.middle;
  const double distance = glm::length(towards - glm::dot(towards, e.up) * e.up);
  const double radius = distance > 1e-6 ? std::min(0.5 * e.width, 0.5 * distance) : 0.5 * e.width;
  const Vector half = 0.5 * e.height * e.up;
  return {e.middle - half, e.middle + half, radius};
}

SphereMirror sphereOf(const Extent& e, const Point& eye) {
  const double size = 0.5 * std::min(e.width, e.height), distance = glm::length(eye - e.middle);
  return {e.middle, distance > 1e-6 ? std::min(size, 0.5 * distance) : size};
}

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

// A level has room for scales from a millionth to a million.
double scaleInto(const Box& own, const Box& room) {
  const double factor = factorInto(own, room);
  return factor >= limits::lengths.min && factor <= limits::lengths.max ? factor : 1;
}

}  // namespace

MirrorShape mirrorOfKind(std::size_t kind, const MirrorShape& old, const Point& eye) {
  if (kind == old.index()) return old;
  const Extent extent = extentOf(old);
  if (kind == 0) return planeOf(extent, eye);
  if (kind == 1) return cylinderOf(extent, eye);
  return sphereOf(extent, eye);
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
  Level result = level;
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

Level withBuiltInOriginal(const Level& level, std::size_t kind, const Box& box) {
  OriginalShape shape = builtInShape(kind);
  if (auto* filling = std::get_if<BoxShape>(&shape); filling && !box.empty()) {
    filling->size = glm::clamp(box.size(), Vector(limits::lengths.min), Vector(limits::lengths.max));
  }
  const auto mesh = loadOriginal(shape, {});
  return withOriginal(level, std::move(shape), *mesh, box);
}

}  // namespace anamorph
