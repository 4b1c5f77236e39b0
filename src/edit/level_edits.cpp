#include "edit/level_edits.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "level/limits.h"

namespace anamorph {
namespace {

constexpr double maxCoordinate = limits::coordinates.max;
constexpr double minLength = limits::lengths.min, maxLength = limits::lengths.max;
constexpr double minDepthScale = limits::depthScale.level.min, maxDepthScale = limits::depthScale.level.max;

bool isLight(const Level& level, const Selection& selection) {
  return selection.part == Part::light && selection.index >= 0 &&
         static_cast<std::size_t>(selection.index) < level.lights.size();
}

// Rotation about an axis (Rodrigues' formula).
glm::dmat3 turnAbout(const Direction& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  glm::dmat3 m;
  for (int i = 0; i < 3; ++i) {
    const Vector e = sceneAxes[static_cast<std::size_t>(i)];
    m[i] = c * e + s * glm::cross(axis, e) + (1 - c) * glm::dot(axis, e) * axis;
  }
  return m;
}

bool areAxes(const Axes& axes) {
  return std::all_of(axes.begin(), axes.end(),
                     [](const Direction& d) { return std::abs(glm::length(d) - 1) < 1e-9; });
}

ShapeMap mapOf(std::function<Point(const Point&)> point, const Vector& factors = Vector(1)) {
  return {std::move(point), factors, minLength, maxLength};
}

// x to the right of the image, y ahead, z up.
Axes axesOf(const Camera& camera) {
  const Frame frame = Projection(camera, 1, 1).frame();
  return {frame.right, frame.forward, frame.up};
}

Axes ownAxes(const Level& level, const Selection& selection) {
  Axes axes = sceneAxes;
  if (selection.part == Part::eye || selection.part == Part::aim) axes = axesOf(level.camera);
  if (selection.part == Part::mirror) axes = axesOf(level.optic.shape());
  if (const auto control = controlPointOf(level, selection)) axes = control->axes;
  if (selection.part == Part::original) {
    const glm::dmat3 m = rotationMatrix(level.original.placement.rotationDegrees);
    axes = {m[0], m[1], m[2]};
  }
  return areAxes(axes) ? axes : sceneAxes;  // a mirror without area has none
}

// A placed mesh turns about its position when that is inside it, else about its middle.
Point pivotOf(const Placement& placement, const Box& box) {
  if (box.empty()) return placement.position;
  const Vector gap = glm::max(box.min - placement.position, placement.position - box.max);
  const double outside = std::max({gap.x, gap.y, gap.z});
  return outside > 0.1 * box.diagonal() ? box.centre() : placement.position;
}

Point originOf(const Level& level, const Selection& selection, const Box& originalBox,
               const Box& sculptureBox) {
  switch (selection.part) {
    case Part::none:
      break;
    case Part::eye:
      return level.camera.eye;
    case Part::aim:
      return level.camera.target;
    case Part::original:
      return pivotOf(level.original.placement, originalBox);
    case Part::mirror:
      return middleOf(level.optic.shape());
    case Part::sculpture:
      return sculptureBox.centre();
    case Part::controlPoint:
      return controlPointOf(level, selection).value_or(ControlPoint{}).at;
    case Part::light:
      return level.lights[static_cast<std::size_t>(selection.index)].position;
  }
  return Point(0);
}

// Calls change(point) for every point that the selection is made of.
template <typename Change>
void changePoints(Level& level, const Selection& selection, const Change& change) {
  switch (selection.part) {
    case Part::none:
    case Part::sculpture:
    case Part::controlPoint:  // see moved()
      return;
    case Part::eye:
      return change(level.camera.eye);
    case Part::aim:
      return change(level.camera.target);
    case Part::original:
      return change(level.original.placement.position);
    case Part::mirror: {
      const auto each = [&](Point p) {
        change(p);
        return p;
      };
      level.optic.shape() = mapShape(level.optic.shape(), mapOf(each));
      return;
    }
    case Part::light:
      return change(level.lights[static_cast<std::size_t>(selection.index)].position);
  }
}

}  // namespace

Point clampedPoint(const Point& point) {
  return glm::clamp(point, Point(-maxCoordinate), Point(maxCoordinate));
}

std::optional<ControlPoint> controlPointOf(const Level& level, const Selection& selection) {
  if (selection.part != Part::controlPoint || selection.index < 0) return std::nullopt;
  const std::vector<ControlPoint> all = controlPointsOf(level.optic.shape());
  const auto number = static_cast<std::size_t>(selection.index);
  return number < all.size() ? std::optional(all[number]) : std::nullopt;
}

bool allows(const Level& level, const Selection& selection, GizmoMode mode) {
  switch (selection.part) {
    case Part::none:
      return false;
    case Part::eye:
      return mode != GizmoMode::scale;
    case Part::aim:
      return mode == GizmoMode::move;
    case Part::original:
      return true;
    case Part::mirror:
      return mode != GizmoMode::rotate || !isRound(level.optic.shape());
    case Part::sculpture:
      return mode == GizmoMode::scale && !level.sculpture.frozen;
    case Part::controlPoint:
      return mode == GizmoMode::move && controlPointOf(level, selection);
    case Part::light:
      return mode == GizmoMode::move && isLight(level, selection);
  }
  return false;
}

bool scalesUniformly(const Level& level, const Selection& selection) {
  return selection.part == Part::sculpture ||
         (selection.part == Part::mirror && hasOneSize(level.optic.shape()));
}

std::optional<GizmoFrame> frameOf(const Level& level, const Selection& selection, GizmoMode mode, bool local,
                                  const Box& originalBox, const Box& sculptureBox) {
  if (!allows(level, selection, mode)) return std::nullopt;
  if (selection.part == Part::sculpture && sculptureBox.empty()) return std::nullopt;
  GizmoFrame frame;
  frame.origin = originOf(level, selection, originalBox, sculptureBox);
  if (!isFinite(frame.origin)) return std::nullopt;
  if (local || mode == GizmoMode::scale || selection.part == Part::controlPoint)
    frame.axes = ownAxes(level, selection);
  return frame;
}

Box boxOf(const Level& level, const Selection& selection, const Box& originalBox, const Box& sculptureBox) {
  if (selection.part == Part::original) return originalBox;
  if (selection.part == Part::sculpture) return sculptureBox;
  if (selection.part == Part::mirror) return boxOf(level.optic.shape());
  Box box;
  if (!allows(level, selection, GizmoMode::move)) return box;
  const Point point = originOf(level, selection, originalBox, sculptureBox);
  box.extend(point - Vector(0.5));
  box.extend(point + Vector(0.5));
  return box;
}

Level moved(const Level& level, const Selection& selection, const Vector& vector) {
  Level result = level;
  if (!allows(level, selection, GizmoMode::move) || !isFinite(vector) || vector == Vector(0)) return result;
  if (const auto control = controlPointOf(level, selection)) {
    const Vector motion = clampedPoint(control->at + vector) - control->at;
    result.optic.shape() =
        withControlPointMoved(level.optic.shape(), static_cast<std::size_t>(selection.index), motion);
    return result;
  }
  Box box;
  changePoints(result, selection, [&](const Point& p) { box.extend(p); });
  // All points by the same vector, so that nothing is bent where coordinates end.
  const Vector low = glm::min(Vector(-maxCoordinate) - box.min, Vector(0));
  const Vector high = glm::max(Vector(maxCoordinate) - box.max, Vector(0));
  const Vector shift = glm::clamp(vector, low, high);
  changePoints(result, selection, [&](Point& p) { p = clampedPoint(p + shift); });
  return result;
}

Level rotated(const Level& level, const Selection& selection, const Point& origin, const Direction& axis,
              double angleRadians) {
  Level result = level;
  if (!allows(level, selection, GizmoMode::rotate) || !std::isfinite(angleRadians) || angleRadians == 0)
    return result;
  if (!isFinite(origin) || !(std::abs(glm::length(axis) - 1) < 1e-6)) return result;
  const glm::dmat3 turn = turnAbout(axis, angleRadians);
  const auto map = [&](const Point& p) { return clampedPoint(origin + turn * (p - origin)); };
  if (selection.part == Part::eye) {
    Camera& camera = result.camera;
    const Vector sight = camera.target - camera.eye;
    // About the line of sight the aim stays and the image turns; else up stays up.
    if (glm::length(glm::cross(sight, axis)) < 1e-6 * glm::length(sight)) {
      camera.up = turn * camera.up;
    } else {
      camera.target = clampedPoint(camera.eye + turn * sight);
    }
  } else if (selection.part == Part::original) {
    Placement& placement = result.original.placement;
    placement.rotationDegrees =
        eulerDegrees(turn * rotationMatrix(placement.rotationDegrees), placement.rotationDegrees);
    if (placement.position != origin) placement.position = map(placement.position);
  } else {
    result.optic.shape() = mapShape(level.optic.shape(), mapOf(map));
  }
  return result;
}

Level scaled(const Level& level, const Selection& selection, const Point& origin, const Vector& factors) {
  Level result = level;
  if (!allows(level, selection, GizmoMode::scale) || !isFinite(origin) || !isFinite(factors)) return result;
  Vector f = glm::max(factors, Vector(0));
  if (scalesUniformly(level, selection)) f = Vector(ShapeMap::strongest({f.x, f.y, f.z}));
  if (f == Vector(1)) return result;
  const Axes axes = ownAxes(level, selection);
  const auto map = [&](const Point& p) {
    Point q = p;
    for (int i = 0; i < 3; ++i) {
      const Direction& axis = axes[static_cast<std::size_t>(i)];
      if (f[i] != 1) q += (f[i] - 1) * glm::dot(p - origin, axis) * axis;
    }
    return q;
  };
  if (selection.part == Part::sculpture) {
    result.sculpture.depthScale = std::clamp(level.sculpture.depthScale * f.x, minDepthScale, maxDepthScale);
  } else if (selection.part == Part::original) {
    Placement& placement = result.original.placement;
    placement.scale = glm::clamp(placement.scale * f, Vector(minLength), Vector(maxLength));
    placement.position = clampedPoint(map(placement.position));
  } else {
    const auto within = [&](const Point& p) { return clampedPoint(map(p)); };
    result.optic.shape() = mapShape(level.optic.shape(), mapOf(within, f));
  }
  return result;
}

}  // namespace anamorph
