#include "edit/gizmo_drag.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/language.h"

namespace anamorph {
namespace {

constexpr double parallelSine = 1e-4;  // a ray nearer to an axis or a plane than this says nothing
constexpr double edgeOnRing = 0.12;    // sine; flatter rings turn by motion along them
constexpr double farthest = 2e6;       // no position of a level is farther away from another, nearly
constexpr const char* axisNames[] = {"x", "y", "z"};

constexpr GizmoHandle axisHandles[] = {GizmoHandle::x, GizmoHandle::y, GizmoHandle::z};

double toStep(double value, double step) {
  return std::round(value / step) * step;
}

bool isAxis(GizmoHandle handle) {
  return handle == GizmoHandle::x || handle == GizmoHandle::y || handle == GizmoHandle::z;
}

bool isFinitePixel(const Pixel& p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

}  // namespace

GizmoDrag::GizmoDrag(GizmoDragStart start) : start_(std::move(start)), handle_(start_.handle) {
  chooseHandle({});
}

// Another handle measures something else, so what was remembered of the former one goes.
void GizmoDrag::chooseHandle(const DragKeys& keys) {
  GizmoHandle handle = start_.handle;
  const bool uniform = start_.mode == GizmoMode::scale && scalesUniformly(start_.level, start_.selection);
  if (keys.axisLock && !uniform) handle = axisHandles[std::clamp(*keys.axisLock, 0, 2)];
  if (handle == handle_ && ringStart_) return;
  if (handle != handle_) last_ = slowed_ = Vector(0);
  handle_ = handle;
  ringTurns_ = 0;
  ringStart_ = ringLast_ =
      start_.mode == GizmoMode::rotate ? ringAngle(start_.pixel, handleAxis()) : std::nullopt;
}

Level GizmoDrag::levelAt(const Pixel& pixel, const DragKeys& keys) {
  chooseHandle(keys);
  const Vector before = last_;
  if (isFinitePixel(pixel)) {
    const auto measured = measure(pixel);
    if (measured && isFinite(*measured)) last_ = *measured;
  }
  if (keys.fine) slowed_ += (1 - fineFraction) * (last_ - before);
  const Vector value = last_ - slowed_;
  const bool unmoved = value == Vector(0);  // then nothing snaps either
  const double snap = keys.snap && !unmoved ? (keys.fine ? fineFraction : 1.0) : 0.0;
  switch (start_.mode) {
    case GizmoMode::move:
      return applyMove(value, snap * snapLength);
    case GizmoMode::rotate:
      return applyTurn(value.x, snap * radians(snapAngleDegrees));
    case GizmoMode::scale:
      return applyScale(1 + value.x, snap * snapFactor);
  }
  return start_.level;
}

// ---- What the mouse says

std::optional<Vector> GizmoDrag::measure(const Pixel& pixel) {
  if (pixel == start_.pixel && start_.mode != GizmoMode::rotate) return Vector(0);
  if (start_.mode == GizmoMode::move) return measureMove(pixel);
  const auto value = start_.mode == GizmoMode::rotate ? measureTurn(pixel) : measureScale(pixel);
  return value ? std::optional(Vector(*value, 0, 0)) : std::nullopt;
}

std::optional<Vector> GizmoDrag::measureMove(const Pixel& pixel) const {
  if (isAxis(handle_)) {
    const Direction axis = handleAxis();
    const auto from = onAxis(start_.pixel, axis), to = onAxis(pixel, axis);
    return from && to ? std::optional((*to - *from) * axis) : std::nullopt;
  }
  const Direction normal = handle_ == GizmoHandle::all ? start_.projection.frame().forward : handleAxis();
  const auto from = onPlane(start_.pixel, normal), to = onPlane(pixel, normal);
  return from && to ? std::optional(*to - *from) : std::nullopt;
}

// Where the handle was taken the factor is 1, at the origin 0, beyond it no less.
std::optional<double> GizmoDrag::measureScale(const Pixel& pixel) const {
  const double length = gizmoPixels * start_.uiScale;
  if (handle_ ==
      GizmoHandle::all) {  // taken at the origin, where no distance is: to the right and up makes larger
    const Pixel way = pixel - start_.pixel;
    return std::max((way.x - way.y) / length, -1.0);
  }
  double reach = 0, now = 0;
  if (isAxis(handle_)) {
    const auto from = onAxis(start_.pixel, handleAxis()), to = onAxis(pixel, handleAxis());
    if (!from || !to) return std::nullopt;
    reach = *from;
    now = *to;
  } else {
    const auto from = onPlane(start_.pixel, handleAxis()), to = onPlane(pixel, handleAxis());
    if (!from || !to) return std::nullopt;
    reach = glm::length(*from);
    now = reach > 0 ? glm::dot(*from, *to) / reach : 0;
  }
  // Taken (by an axis lock) too near to the origin: an axis' length stands for the distance.
  const double unit = length * start_.projection.unitsPerPixel(start_.frame.origin);
  if (std::abs(reach) < 0.05 * unit) return std::max((now - reach) / unit, -1.0);
  return std::max(now / reach, 0.0) - 1;
}

std::optional<double> GizmoDrag::measureTurn(const Pixel& pixel) {
  const Direction axis = handleAxis();
  if (const auto tangent = edgeOnTangent(axis)) {
    return glm::dot(pixel - start_.pixel, *tangent) / (gizmoPixels * start_.uiScale);
  }
  const auto angle = ringAngle(pixel, axis);
  if (!angle) return std::nullopt;
  if (!ringStart_) ringStart_ = ringLast_ = angle;
  if (*angle - *ringLast_ > pi) --ringTurns_;
  if (*ringLast_ - *angle > pi) ++ringTurns_;
  ringLast_ = angle;
  return *angle - *ringStart_ + 2 * pi * ringTurns_;
}

// From the origin to where the ray meets the plane through it.
std::optional<Vector> GizmoDrag::onPlane(const Pixel& pixel, const Direction& normal) const {
  const Ray ray = start_.projection.rayThrough(pixel);
  const double slope = glm::dot(ray.direction, normal);
  const double t = glm::dot(start_.frame.origin - ray.origin, normal) / slope;
  if (!(std::abs(slope) > parallelSine)) return std::nullopt;
  if (!start_.projection.orthographic() && !(t > 0)) return std::nullopt;
  const Vector v = ray.at(t) - start_.frame.origin;
  return glm::length(v) < farthest ? std::optional(v) : std::nullopt;
}

// The place along the axis, from the origin, that is nearest to the ray. With w from the ray's origin to the
// axis' origin and c the cosine between them: s = (c (d.w) - a.w) / (1 - c^2), and t = (d.w - c (a.w)) / (1 -
// c^2) on the ray.
std::optional<double> GizmoDrag::onAxis(const Pixel& pixel, const Direction& axis) const {
  const Ray ray = start_.projection.rayThrough(pixel);
  const double c = glm::dot(ray.direction, axis),
               sineSquared = lengthSquared(glm::cross(ray.direction, axis));
  if (!(sineSquared > parallelSine * parallelSine)) return std::nullopt;
  const Vector w = start_.frame.origin - ray.origin;
  const double along = glm::dot(ray.direction, w), s = (c * along - glm::dot(axis, w)) / sineSquared;
  const double t = (along - c * glm::dot(axis, w)) / sineSquared;
  if (!start_.projection.orthographic() && !(t > 0)) return std::nullopt;  // past the axis' vanishing point
  return std::abs(s) < farthest ? std::optional(s) : std::nullopt;
}

std::optional<double> GizmoDrag::ringAngle(const Pixel& pixel, const Direction& axis) const {
  const auto v = onPlane(pixel, axis);
  if (!v) return std::nullopt;
  const Direction a = perpendicular(axis), b = glm::cross(axis, a);
  const double x = glm::dot(*v, a), y = glm::dot(*v, b);
  const double pixelSize = start_.projection.unitsPerPixel(start_.frame.origin);
  return std::hypot(x, y) > pixelSize ? std::optional(std::atan2(y, x))
                                      : std::nullopt;  // at the centre: no angle
}

// For a ring seen edge-on: the direction on the screen in which its front part moves.
std::optional<Pixel> GizmoDrag::edgeOnTangent(const Direction& axis) const {
  const Direction view = viewDirection(start_.projection, start_.frame.origin);
  if (std::abs(glm::dot(axis, view)) > edgeOnRing) return std::nullopt;
  const Vector tangent = glm::cross(axis, -view);
  const Frame& frame = start_.projection.frame();
  const Pixel onScreen(glm::dot(tangent, frame.right), -glm::dot(tangent, frame.up));
  const double length = glm::length(onScreen);
  return length > 1e-6 ? std::optional(onScreen / length) : std::nullopt;
}

// ---- What becomes of the level

// Of a plane: its normal. In the plane of the picture: towards the viewer.
Direction GizmoDrag::handleAxis() const {
  const int axis = axisOf(handle_);
  if (axis < 3) return start_.frame.axes[static_cast<std::size_t>(axis)];
  return -viewDirection(start_.projection, start_.frame.origin);
}

bool GizmoDrag::movesAlong(int axis) const {
  const int own = axisOf(handle_);
  return own == 3 || (isAxis(handle_) == (axis == own));
}

Level GizmoDrag::applyMove(Vector motion, double snap) {
  const GizmoFrame& frame = start_.frame;
  text_.clear();
  Vector rounded(0);
  for (int i = 0; i < 3; ++i) {
    if (!movesAlong(i)) continue;
    const Direction& axis = frame.axes[static_cast<std::size_t>(i)];
    double along = glm::dot(motion, axis);
    if (snap > 0) {
      const double from = frame.global() ? frame.origin[i] : 0;
      along = toStep(from + along, snap) - from;
      rounded += along * axis;
    }
    const char* separator = text_.empty() ? (frame.global() ? "" : tr("local ")) : ", ";
    text_ += shownFormat("{}{} {:+.2f}", separator, axisNames[i], along);
  }
  return moved(start_.level, start_.selection, snap > 0 ? rounded : motion);
}

Level GizmoDrag::applyTurn(double angle, double snap) {
  if (snap > 0) angle = toStep(angle, snap);
  const int axis = axisOf(handle_);
  const char* about = axis < 3 ? axisNames[axis] : tr("the line of sight");
  const char* local = axis < 3 && !start_.frame.global() ? tr("local ") : "";
  text_ = trFormat("{:.1f}° about {}{}", degrees(angle), local, about);
  return rotated(start_.level, start_.selection, start_.frame.origin, handleAxis(), angle);
}

// The sculpture's factor is that of its depth scale, which snaps by itself.
Level GizmoDrag::applyDepth(double factor, double snap) {
  const double before = start_.level.sculpture.depthScale;
  if (snap > 0 && before > 0) factor = toStep(factor * before, 0.5 * snap) / before;
  const Level level = scaled(start_.level, start_.selection, start_.frame.origin, Vector(factor));
  text_ = shownFormat("k = {:.2f}", level.sculpture.depthScale);
  return level;
}

Level GizmoDrag::applyScale(double factor, double snap) {
  if (start_.selection.part == Part::sculpture) return applyDepth(factor, snap);
  if (snap > 0) factor = toStep(factor, snap);
  factor = std::max(factor, 0.0);
  Vector factors(1);
  std::string names;
  for (int i = 0; i < 3; ++i) {
    if (!movesAlong(i)) continue;
    factors[i] = factor;
    names += axisNames[i];
  }
  text_ = names.size() == 3 ? trFormat("scale {:.2f}", factor) : trFormat("scale {} {:.2f}", names, factor);
  return scaled(start_.level, start_.selection, start_.frame.origin, factors);
}

}  // namespace anamorph
