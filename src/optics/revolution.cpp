#include "optics/revolution.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/language.h"
#include "math/quadratic.h"

namespace anamorph {
namespace {

using Prepared = RevolutionMirror::Prepared;

// rho^2 along a piece of a ray.
Bernstein<6> distanceSquared(const Point& from, const Vector& way) {
  const double a = from.x * from.x + from.y * from.y, b = 2 * (from.x * way.x + from.y * way.y),
               c = way.x * way.x + way.y * way.y;
  Bernstein<6> p;
  for (int k = 0; k <= 6; ++k) {
    p.c[static_cast<std::size_t>(k)] = a + b * (k * (1.0 / 6)) + c * (k * (k - 1) * (1.0 / 30));
  }
  return p;
}

Bernstein<6> squared(const Cubic& p) {
  std::array<Cubic, 4> products;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) products[i].c[j] = p.c[i] * p.c[j];
  }
  return alongDiagonal(products);
}

// Where the ray is between both ends and not farther out than the widest place.
Stretch stretchNear(const Prepared& prepared, const FrameRay& ray, Stretch stretch) {
  stretch.keepBetween(ray.at.z, ray.direction.z, 0, prepared.height);
  const double a = ray.direction.x * ray.direction.x + ray.direction.y * ray.direction.y;
  const double b = ray.at.x * ray.direction.x + ray.at.y * ray.direction.y;
  const double wide = prepared.widest * (1 + 1e-9);
  const double c = ray.at.x * ray.at.x + ray.at.y * ray.at.y - wide * wide;
  if (a == 0) return c > 0 ? Stretch{1, 0} : stretch;  // along the axis
  const auto inside = solveQuadratic(a, b, c);
  if (!inside) return {1, 0};
  return {std::max(stretch.from, inside->first), std::min(stretch.to, inside->second)};
}

// Whether rho is plainly above or below the span's radii from one point of the ray to another.
bool isPlainlyBeside(const RevolutionMirror::Span& span, const Point& from, const Vector& way) {
  constexpr double slack = 1e-9;
  const double a = way.x * way.x + way.y * way.y, b = from.x * way.x + from.y * way.y;
  const double one = from.x * from.x + from.y * from.y, other = one + 2 * b + a;
  if ((1 + slack) * std::max(one, other) < span.least * span.least) return true;
  const double far = (1 + slack) * span.greatest * span.greatest;
  const bool turns = b < 0 && b + a > 0;  // nearest to the axis in between
  return turns ? one * a - b * b > far * a : std::min(one, other) > far;
}

// rho^2 - r^2 from one point of the ray to another; nothing where it is plainly not 0.
std::optional<Bernstein<6>> gapAlong(const RevolutionMirror::Span& span, const Point& from, const Point& to,
                                     double bottomOfSpan, double spanHeight) {
  const Vector way = to - from;
  if (isPlainlyBeside(span, from, way)) return std::nullopt;
  const Bernstein<6> rho2 = distanceSquared(from, way);
  const Cubic r =
      partOf(span.radius, (from.z - bottomOfSpan) / spanHeight, (to.z - bottomOfSpan) / spanHeight);
  Bernstein<6> gap = squared(r);
  for (std::size_t i = 0; i < 7; ++i) gap.c[i] = rho2.c[i] - gap.c[i];
  return gap;
}

}  // namespace

ValueAndSlope RevolutionMirror::Prepared::radiusAt(double h) const {
  const double u = h / spanHeight();
  const double last = static_cast<double>(spans.size()) - 1, span = std::clamp(std::floor(u), 0.0, last);
  const ValueAndSlope r = valueAndSlope(spans[static_cast<std::size_t>(span)].radius, u - span);
  return {r.value, r.slope / spanHeight()};
}

RevolutionMirror::Prepared RevolutionMirror::prepare() const {
  Prepared prepared{axes(), height(), 0, {}};
  for (const Cubic& radius : splineSpans(radii)) {
    const auto [least, greatest] = rangeOf(radius);
    prepared.spans.push_back({radius, least, greatest});
    prepared.widest = std::max(prepared.widest, greatest);
  }
  return prepared;
}

std::optional<SurfaceHit> RevolutionMirror::firstHit(const Prepared& prepared, const Ray& ray, double tMin,
                                                     const Stretch& within) const {
  if (prepared.spans.empty()) return std::nullopt;
  const FrameRay local = rayInFrame(ray, bottom, prepared.axes);
  const Stretch stretch = stretchNear(prepared, local, within.countedFrom(local.start));
  const double nearest = tMin - local.start;
  const double overlap = pieceOverlap * (prepared.height + prepared.widest) / glm::length(local.direction);
  if (stretch.empty() || stretch.to + overlap <= nearest) return std::nullopt;

  const double spanHeight = prepared.spanHeight(), last = static_cast<double>(prepared.spans.size()) - 1;
  const auto spanAt = [&](double way) {
    return std::clamp(std::floor(local.after(way).z / spanHeight), 0.0, last);
  };
  const double end = spanAt(stretch.to), step = local.direction.z < 0 ? -1 : 1;
  CrossingFilter filter(4 * overlap);
  double from = stretch.from;
  for (double span = spanAt(stretch.from);; span += step) {
    const double knot = (step > 0 ? span + 1 : span) * spanHeight;
    const double to =
        span == end ? stretch.to : std::clamp((knot - local.at.z) / local.direction.z, from, stretch.to);
    if (to + overlap > nearest) {
      const double start = from - overlap, length = to + overlap - start;
      const auto gap = gapAlong(prepared.spans[static_cast<std::size_t>(span)], local.after(start),
                                local.after(to + overlap), span * spanHeight, spanHeight);
      for (const Crossing& crossing :
           gap ? findCrossings(*gap, (nearest - start) / length) : Crossings<6>{}) {
        const double way = start + crossing.at * length, t = local.start + way;
        if (!filter.isNew(way, crossing.rising) || !(t > tMin)) continue;
        const Point at = local.after(way);
        const double rho = std::hypot(at.x, at.y);
        return hitAt(ray, t, prepared.axes, {at.x / rho, at.y / rho, -prepared.radiusAt(at.z).slope});
      }
    }
    if (span == end) return std::nullopt;
    from = to;
  }
}

std::optional<std::string> RevolutionMirror::findProblem() const {
  if (radii.size() < fewestOpenControls) {
    return trFormat("expected at least {} radii, got {}", fewestOpenControls, radii.size());
  }
  if (!(height() > 0)) {
    return tr("expected a top that is not at the bottom, got a turned profile of height 0");
  }
  const std::vector<Cubic> spans = splineSpans(radii);
  for (std::size_t i = 0; i < spans.size(); ++i) {
    if (rangeOf(spans[i]).first > 0) continue;
    return trFormat(
        "expected a radius > 0 all over the profile, got {:.3g} between the heights {:.3g} and {:.3g}",
        rangeOf(spans[i]).first, height() * double(i) / double(spans.size()),
        height() * double(i + 1) / double(spans.size()));
  }
  return std::nullopt;
}

std::optional<std::string> RevolutionMirror::findEyeProblem(const Prepared& prepared,
                                                            const Point& eye) const {
  if (auto problem = findDistanceProblem(glm::length(eye - middle()), prepared.widest)) return problem;
  const Vector at = inFrame(prepared.axes, eye - bottom);
  const double tolerance = shapeTolerance * prepared.widest;
  if (!(at.z >= -tolerance && at.z <= prepared.height + tolerance)) return std::nullopt;
  const auto [radius, slope] = prepared.radiusAt(std::clamp(at.z, 0.0, prepared.height));
  if (std::abs(std::hypot(at.x, at.y) - radius) > tolerance * std::hypot(1, slope)) return std::nullopt;
  return findContactProblem(0, 1);
}

Point RevolutionMirror::eyeOutside(const Point& eye, const Point& original) const {
  const auto across = [&](const Vector& v) { return v - glm::dot(v, axis()) * axis(); };
  const double along = std::clamp(glm::dot(eye - bottom, axis()), -10 * height(), 10 * height());
  return bottom + along * axis() +
         2 * widest() * wayOut(across(eye - bottom), across(bottom - original), perpendicular(axis()));
}

Box RevolutionMirror::box() const {
  const std::vector<Cubic> spans = splineSpans(radii);
  const double thirds = 3 * static_cast<double>(spans.size());
  const Vector reach = glm::sqrt(glm::max(1.0 - axis() * axis(), Vector(0)));
  Box box;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    Point low(0), high(0);
    for (int k = 0; k < 3; ++k) {  // the circles' outermost points are cubics, too
      Cubic least, greatest;
      for (std::size_t j = 0; j < 4; ++j) {
        const double centre = bottom[k] + static_cast<double>(3 * i + j) / thirds * (top - bottom)[k];
        least.c[j] = centre - reach[k] * spans[i].c[j];
        greatest.c[j] = centre + reach[k] * spans[i].c[j];
      }
      low[k] = rangeOf(least).first;
      high[k] = rangeOf(greatest).second;
    }
    box.extend({low, high});
  }
  return box;
}

// A vase whose widest place is 1.
RevolutionMirror RevolutionMirror::filling(const ShapeExtent& e, const Point& eye) {
  const Vector half = 0.5 * e.height * e.up;
  RevolutionMirror made;
  made.bottom = e.middle - half;
  made.top = e.middle + half;
  const double factor = fillingRadius(e, eye) / made.widest();
  for (double& radius : made.radii) radius *= factor;
  return made;
}

// A control value stands at a knot, the outermost ones a span beyond the ends.
std::vector<ControlPoint> RevolutionMirror::controlPoints() const {
  const Axes a = axes();
  std::vector<ControlPoint> points;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double h = (static_cast<double>(i) - 1) * height() / spanCount();
    points.push_back({bottom + h * a[2] - radii[i] * a[1], {-a[1], a[0], a[2]}, 1});
  }
  return points;
}

void RevolutionMirror::moveControlPoint(std::size_t number, const Vector& motion) {
  if (number >= radii.size()) return;
  const double smallest = shapeTolerance * widest();
  radii[number] = std::max(radii[number] - glm::dot(motion, axes()[1]), smallest);
}

void RevolutionMirror::map(const ShapeMap& map) {
  for (double& radius : radii) radius = map.size(radius, {map.factors.x, map.factors.y});
  bottom = map.point(bottom);
  top = map.point(top);
}

void RevolutionMirror::carryOn() {
  if (radii.size() < fewestOpenControls) return;
  const std::size_t more = radii.size() - 3;
  const Vector along = top - bottom;
  const double atBottom = radii.front(), atTop = radii.back();
  radii.insert(radii.begin(), more, atBottom);
  radii.insert(radii.end(), more, atTop);
  bottom -= along;
  top += along;
}

Point RevolutionMirror::pointAt(double u, double v) const {
  const double radius = splineAt(radii, v * spanCount()).value;
  return glm::mix(bottom, top, v) + radius * around(axis(), u);
}

Direction RevolutionMirror::normalAt(double u, double v) const {
  const double slope = splineAt(radii, v * spanCount()).slope * spanCount() / height();
  return glm::normalize(around(axis(), u) - slope * axis());
}

int RevolutionMirror::spanCount() const {
  return std::max(1, static_cast<int>(radii.size()) - 3);
}

// Rows end at knots.
std::array<int, 2> RevolutionMirror::gridFor(int segments) const {
  return {segments, spanCount() * std::max(2, segments / 2 / spanCount())};
}

SurfaceLines RevolutionMirror::lines() const {
  return {16, 4, true, 48, std::min(8 * spanCount(), 200), {}, {0, 1}};
}

double RevolutionMirror::borderDistance(const Point& p) const {
  const double along = glm::dot(p - bottom, axis());
  const double size = std::max(height(), 2 * *std::max_element(radii.begin(), radii.end()));
  return std::min(along, height() - along) / size;
}

ShapeWords RevolutionMirror::words(LengthText text) const {
  constexpr int steps = 8;
  std::string table;
  for (int i = 0; i <= steps; ++i) {
    const double v = double(i) / steps;
    const double radius = glm::length(pointAt(0, v) - glm::mix(bottom, top, v));
    table += (i > 0 ? ", " : "") + text(v * height()) + ": " + text(2 * radius);
  }
  return {trFormat("A turned profile, {} mm high, {} mm across at its widest. Its diameter at each height, "
                   "in mm: {}. ",
                   text(height()), text(2 * widest()), table),
          stanceAlong(top - bottom)};
}

}  // namespace anamorph
