#include "optics/extrusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "base/language.h"
#include "optics/spline_ray.h"

namespace anamorph {
namespace {

using Prepared = ExtrusionMirror::Prepared;

struct Rectangle {
  CurvePoint min, max;
  double size() const { return std::max(max.x - min.x, max.y - min.y); }
};

Rectangle rectangleOf(const PlaneCurve& curve) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Rectangle r{CurvePoint(infinity), CurvePoint(-infinity)};
  for (const PlaneCubic& piece : curve) {
    const auto [left, right] = rangeOf(piece.x);
    const auto [low, high] = rangeOf(piece.y);
    r = {glm::min(r.min, CurvePoint(left, low)), glm::max(r.max, CurvePoint(right, high))};
  }
  return r;
}

// How far a piece is beside a line through `at` with the unit normal `n`, along the piece.
Cubic besideLine(const PlaneCubic& piece, const CurvePoint& n, const CurvePoint& at) {
  Cubic beside;
  for (std::size_t i = 0; i < 4; ++i) beside.c[i] = n.x * (piece.x.c[i] - at.x) + n.y * (piece.y.c[i] - at.y);
  return beside;
}

bool isPlainlyOnOneSide(const Cubic& beside, double slack) {
  const auto& [a, b, c, d] = beside.c;
  return std::min(std::min(a, b), std::min(c, d)) > slack ||
         std::max(std::max(a, b), std::max(c, d)) < -slack;
}

std::optional<Prepared::Fault> findFault(const PlaneCurve& curve, bool closed, double size) {
  if (!(size > 0) || !std::isfinite(size)) return std::nullopt;
  if (const auto sharp = findSharpPoint(curve, size)) return Prepared::Fault{*sharp, true};
  const auto contact = findSelfContact(curve, closed, shapeTolerance * size);
  return contact ? std::optional(Prepared::Fault{*contact, false}) : std::nullopt;
}

ExtrusionMirror::Place placeOn(const PlaneCubic& piece, double u) {
  const auto [x, dx] = valueAndSlope(piece.x, u);
  const auto [y, dy] = valueAndSlope(piece.y, u);
  return {{x, y}, {dx, dy}};
}

}  // namespace

Axes ExtrusionMirror::axes() const {
  const Direction z = glm::normalize(axis);
  const Direction x = glm::normalize(across - glm::dot(across, z) * z);
  return {x, glm::cross(z, x), z};
}

ExtrusionMirror::Prepared ExtrusionMirror::prepare() const {
  Prepared prepared{axes(), origin, CurvePoint(0), 0, splineCurve(points, closed), {}};
  if (prepared.curve.empty()) return prepared;
  const Rectangle r = rectangleOf(prepared.curve);
  prepared.centre = 0.5 * (r.min + r.max);
  prepared.base += fromFrame(prepared.axes, {prepared.centre, 0});
  prepared.size = r.size();
  std::vector<CurvePoint> centred = points;
  for (CurvePoint& p : centred) p -= prepared.centre;
  prepared.curve = splineCurve(centred, closed);
  prepared.fault = findFault(prepared.curve, closed, prepared.size);
  if (prepared.fault) prepared.fault->at += prepared.centre;
  return prepared;
}

std::optional<SurfaceHit> ExtrusionMirror::intersect(const Prepared& prepared, const Ray& ray,
                                                     double tMin) const {
  if (prepared.curve.empty()) return std::nullopt;
  const FrameRay local = rayInFrame(ray, prepared.base, prepared.axes);
  const CurvePoint at(local.at), line(local.direction);
  const double squared = glm::dot(line, line);
  if (!(squared > 0)) return std::nullopt;  // along the wall
  const CurvePoint n = CurvePoint(-line.y, line.x) / std::sqrt(squared);

  struct {
    double t = std::numeric_limits<double>::infinity(), u = 0;
    const PlaneCubic* piece = nullptr;
  } first;
  CrossingFilter filter(4 * pieceOverlap);
  const double slack = 10 * pieceOverlap * prepared.size;
  const int count = static_cast<int>(prepared.curve.size());
  // The last span of a closed curve comes first, too: only to know what it finds where the first one begins.
  for (int i = closed ? -1 : 0; i < count; ++i) {
    const PlaneCubic& piece = prepared.curve[static_cast<std::size_t>((i + count) % count)];
    const Cubic beside = besideLine(piece, n, at);
    if (isPlainlyOnOneSide(beside, slack)) continue;
    for (const Crossing& crossing : findCrossings(partOf(beside, -pieceOverlap, 1 + pieceOverlap))) {
      const double u = crossing.at * (1 + 2 * pieceOverlap) - pieceOverlap;
      if (!filter.isNew(i + u, crossing.rising) || i < 0) continue;
      const CurvePoint on = placeOn(piece, u).point;
      const double way = glm::dot(on - at, line) / squared, t = local.start + way;
      const double z = local.at.z + way * local.direction.z;
      if (t > tMin && t < first.t && z >= 0 && z <= height) first = {t, u, &piece};
    }
  }
  if (!first.piece) return std::nullopt;
  const CurvePoint slope = placeOn(*first.piece, first.u).slope;
  return hitAt(ray, first.t, prepared.axes, {slope.y, -slope.x, 0});
}

std::optional<std::string> ExtrusionMirror::findProblem(const Prepared& prepared) const {
  const std::size_t fewest = closed ? fewestClosedControls : fewestOpenControls;
  if (points.size() < fewest) return trFormat("expected at least {} points, got {}", fewest, points.size());
  if (auto problem = findLengthProblem("height", height)) return problem;
  if (!(glm::length(axis) > 0)) return tr("expected an axis that is not 0");
  const double sine = glm::length(glm::cross(glm::normalize(axis), glm::normalize(across)));
  if (!(sine > shapeTolerance)) return tr("expected a direction across that is not along the axis");
  if (!(prepared.size > 0) || !std::isfinite(prepared.size))
    return tr("expected points that span a curve, got one of length 0");
  if (!prepared.fault) return std::nullopt;
  const auto roughly = [&](double coordinate) {
    return 1e-3 * prepared.size * std::round(coordinate / prepared.size * 1e3) + 0;
  };
  const double x = roughly(prepared.fault->at.x), y = roughly(prepared.fault->at.y);
  return prepared.fault->isSharp
             ? trFormat("expected a smooth curve, got one that has a sharp point near {:.3g}, {:.3g}", x, y)
             : trFormat("expected a curve that does not meet itself, got one that does near {:.3g}, {:.3g}",
                        x, y);
}

std::optional<std::string> ExtrusionMirror::findEyeProblem(const Prepared& prepared, const Point& eye) const {
  const double size = std::max(prepared.size, height);
  const Vector at = inFrame(prepared.axes, eye - prepared.base);
  if (auto problem = findDistanceProblem(glm::length(at), size, "size")) return problem;
  const double tolerance = shapeTolerance * size;
  if (!(at.z >= -tolerance && at.z <= height + tolerance)) return std::nullopt;
  if (!comesNear(prepared.curve, CurvePoint(at), tolerance)) return std::nullopt;
  return findContactProblem(0, 1);
}

// Before an open wall, away from a closed one.
Point ExtrusionMirror::eyeOutside(const Prepared& prepared, const Point& eye, const Point& original) const {
  const auto flat = [&](const Vector& v) { return v - glm::dot(v, prepared.axes[2]) * prepared.axes[2]; };
  const double along = std::clamp(glm::dot(eye - prepared.base, prepared.axes[2]), -10 * height, 10 * height);
  const double away = std::max(prepared.size, height);
  const Point foot = prepared.base + along * prepared.axes[2];
  if (closed) {
    return foot + 2 * away * wayOut(flat(eye - foot), flat(foot - original), prepared.axes[0]);
  }
  const CurvePoint chord = prepared.curve.back().control(3) - prepared.curve.front().control(0);
  const Direction normal = glm::length(chord) > shapeTolerance * prepared.size
                               ? fromFrame(prepared.axes, {glm::normalize(CurvePoint(chord.y, -chord.x)), 0})
                               : prepared.axes[0];
  return foot + away * (glm::dot(normal, original - foot) > 0 ? -normal : normal);
}

Box ExtrusionMirror::box() const {
  const Axes a = axes();
  const Vector up = height * a[2];
  Box box;
  for (const PlaneCubic& piece : splineCurve(points, closed)) {
    Point low(0), high(0);
    for (int k = 0; k < 3; ++k) {
      Cubic along;
      for (std::size_t j = 0; j < 4; ++j)
        along.c[j] = origin[k] + piece.x.c[j] * a[0][k] + piece.y.c[j] * a[1][k];
      const auto [least, greatest] = rangeOf(along);
      low[k] = least + std::min(0.0, up[k]);
      high[k] = greatest + std::max(0.0, up[k]);
    }
    box.extend({low, high});
  }
  return box;
}

Point ExtrusionMirror::middle(const Prepared& prepared) const {
  return prepared.base + 0.5 * height * prepared.axes[2];
}

ShapeExtent ExtrusionMirror::extent(const Prepared& prepared) const {
  return {middle(prepared), prepared.axes[2], prepared.size, height};
}

ExtrusionMirror ExtrusionMirror::filling(const ShapeExtent& e, const Point& eye) {
  const Vector towards = eye - e.middle, flat = towards - glm::dot(towards, e.up) * e.up;
  const Direction n = glm::length(flat) > 1e-9 ? glm::normalize(flat) : perpendicular(e.up);
  ExtrusionMirror made;
  made.axis = e.up;
  made.across = glm::cross(e.up, n);
  made.height = e.height;
  const double factor = e.width / rectangleOf(splineCurve(made.points, false)).size();
  for (CurvePoint& p : made.points) p *= factor;
  made.origin = e.middle;
  made.origin += e.middle - made.middle(made.prepare());
  return made;
}

// Halfway up the wall.
std::vector<ControlPoint> ExtrusionMirror::controlPoints() const {
  const Axes a = axes();
  std::vector<ControlPoint> made;
  for (const CurvePoint& p : points) {
    made.push_back({origin + p.x * a[0] + p.y * a[1] + 0.5 * height * a[2], a, 2});
  }
  return made;
}

void ExtrusionMirror::moveControlPoint(std::size_t number, const Vector& motion) {
  if (number >= points.size()) return;
  const Axes a = axes();
  points[number] += CurvePoint(glm::dot(motion, a[0]), glm::dot(motion, a[1]));
}

void ExtrusionMirror::map(const ShapeMap& map) {
  const Point old = origin;
  axis = turnedBy(map, old, axis);
  across = turnedBy(map, old, across);
  origin = map.point(old);
  height = map.size(height, map.factors.z);
  const double size = rectangleOf(splineCurve(points, closed)).size();
  if (!(size > 0)) return;
  const CurvePoint factors(map.size(size, map.factors.x) / size, map.size(size, map.factors.y) / size);
  for (CurvePoint& p : points) p *= factors;
}

void ExtrusionMirror::carryOn() {
  constexpr double far = 1e3;
  origin -= far * height * glm::normalize(axis);
  height *= 1 + 2 * far;
  if (points.size() < fewestOpenControls) return;
  const Rectangle r = rectangleOf(splineCurve(points, closed));
  if (closed) {
    const CurvePoint centre = 0.5 * (r.min + r.max);
    for (CurvePoint& p : points) p = centre + 1.05 * (p - centre);
    return;
  }
  const auto beyond = [&](const CurvePoint& end, const CurvePoint& before) {
    return end + r.size() * glm::normalize(end - before);
  };
  const CurvePoint first = beyond(points[0], points[2]);
  const CurvePoint last = beyond(points.back(), points[points.size() - 3]);
  points.insert(points.begin(), first);
  points.push_back(last);
}

int ExtrusionMirror::spanCount() const {
  return std::max(1, static_cast<int>(points.size()) - (closed ? 0 : 3));
}

ExtrusionMirror::Place ExtrusionMirror::placeAt(double u) const {
  const double span = std::clamp(std::floor(u * spanCount()), 0.0, spanCount() - 1.0);
  std::array<CurvePoint, 4> controls;
  for (std::size_t i = 0; i < 4; ++i)
    controls[i] = points[(static_cast<std::size_t>(span) + i) % points.size()];
  return placeOn(splineCurve(controls, false).front(), u * spanCount() - span);
}

Point ExtrusionMirror::pointAt(double u, double v) const {
  const CurvePoint p = placeAt(u).point;
  return origin + fromFrame(axes(), {p, v * height});
}

Direction ExtrusionMirror::normalAt(double u, double) const {
  const CurvePoint slope = placeAt(u).slope;
  return fromFrame(axes(), glm::normalize(Vector(slope.y, -slope.x, 0)));
}

// Columns end at knots.
std::array<int, 2> ExtrusionMirror::gridFor(int segments) const {
  constexpr int rows =
      12;  // the distance to the border is known at corners only, and is not even between two borders
  return {spanCount() * std::max(4, segments / spanCount()), rows};
}

SurfaceLines ExtrusionMirror::lines() const {
  SurfaceLines lines{16, 4, closed, std::min(8 * spanCount(), 200), 1, {}, {0, 1}};
  if (!closed) lines.strongU = {0, 1};
  return lines;
}

double ExtrusionMirror::borderDistance(const Prepared& prepared, const Point& p) const {
  const Vector at = inFrame(prepared.axes, p - prepared.base);
  double nearest = std::min(at.z, height - at.z);
  if (!closed) {
    for (const CurvePoint& end : {prepared.curve.front().control(0), prepared.curve.back().control(3)}) {
      nearest = std::min(nearest, glm::length(CurvePoint(at) - end));
    }
  }
  return nearest / std::max(prepared.size, height);
}

ShapeWords ExtrusionMirror::words(LengthText text) const {
  const PlaneCurve curve = splineCurve(points, closed);
  const Rectangle r = rectangleOf(curve);
  const int steps = std::min(spanCount(), 16);
  std::string table;
  for (int i = 0; i <= steps - (closed ? 1 : 0); ++i) {
    const CurvePoint p = placeAt(double(i) / steps).point;
    table += (i > 0 ? ", " : "") + fmt::format("({}, {})", text(p.x - r.min.x), text(p.y - r.min.y));
  }
  const double lean = degrees(std::atan2(std::hypot(axis.x, axis.y), std::abs(axis.z)));
  return {trFormat("A curved wall, {} mm high, {} x {} mm seen along its axis. It runs through these points, "
                   "in mm: {}. ",
                   text(height), text(r.max.x - r.min.x), text(r.max.y - r.min.y), table),
          lean < 0.05 ? tr("Upright on the blue outline") : stanceAlong(axis)};
}

}  // namespace anamorph
