#include "math/plane_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "math/uniform_spline.h"

namespace anamorph {
namespace {

using Point2 = glm::dvec2;

std::pair<PlaneCubic, PlaneCubic> halves(const PlaneCubic& piece) {
  const auto [x0, x1] = split(piece.x, 0.5);
  const auto [y0, y1] = split(piece.y, 0.5);
  return {{x0, y0}, {x1, y1}};
}

double sizeOf(const PlaneCubic& piece) {
  double size = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    size = std::max(size, glm::length(piece.control(i) - piece.control(0)));
  }
  return size;
}

// By less than 60 degrees from end to end, so that two such pieces in a row do not meet again.
bool turnsLittle(const PlaneCubic& piece) {
  std::array<Point2, 3> d;
  for (std::size_t i = 0; i < 3; ++i) d[i] = piece.control(i + 1) - piece.control(i);
  const auto together = [](const Point2& a, const Point2& b) {
    return glm::dot(a, b) > 0.5 * glm::length(a) * glm::length(b);
  };
  return together(d[0], d[1]) && together(d[1], d[2]) && together(d[0], d[2]);
}

// Adds the parts of a piece that turn little; those that stay small and turn, whatever is done, are sharp.
void addGentleParts(const PlaneCubic& piece, double smallest, PlaneCurve& parts,
                    std::optional<Point2>& sharp) {
  if (sharp) return;
  if (turnsLittle(piece)) {
    parts.push_back(piece);
  } else if (!(sizeOf(piece) > smallest)) {
    sharp = piece.control(0);
  } else {
    const auto [first, second] = halves(piece);
    addGentleParts(first, smallest, parts, sharp);
    addGentleParts(second, smallest, parts, sharp);
  }
}

struct Interval {
  double low, high;
};
Interval along(const PlaneCubic& piece, const Point2& direction) {
  Interval interval{glm::dot(piece.control(0), direction), glm::dot(piece.control(0), direction)};
  for (std::size_t i = 1; i < 4; ++i) {
    const double at = glm::dot(piece.control(i), direction);
    interval = {std::min(interval.low, at), std::max(interval.high, at)};
  }
  return interval;
}

// Whether along or across this piece's chord the two are farther apart than `gap`.
bool areApart(const PlaneCubic& a, const PlaneCubic& b, double gap) {
  const Point2 chord = a.control(3) - a.control(0);
  const double length = glm::length(chord);
  if (!(length > 0)) return false;
  const Point2 x = chord / length, y(-x.y, x.x);
  const auto apartAlong = [&](const Point2& direction) {
    const Interval one = along(a, direction), other = along(b, direction);
    return other.low - one.high > gap || one.low - other.high > gap;
  };
  return apartAlong(x) || apartAlong(y);
}

std::optional<Point2> findContact(const PlaneCubic& a, const PlaneCubic& b, double gap) {
  if (areApart(a, b, gap) || areApart(b, a, gap)) return std::nullopt;
  const bool splitsFirst = sizeOf(a) > sizeOf(b);
  const PlaneCubic &larger = splitsFirst ? a : b, &smaller = splitsFirst ? b : a;
  if (!(sizeOf(larger) > gap)) return larger.control(0);
  const auto [first, second] = halves(larger);
  if (const auto contact = findContact(first, smaller, gap)) return contact;
  return findContact(second, smaller, gap);
}

PlaneCubic standing(const Point2& p) {
  return {{{p.x, p.x, p.x, p.x}}, {{p.y, p.y, p.y, p.y}}};
}

}  // namespace

PlaneCurve splineCurve(std::span<const Point2> controls, bool closed) {
  std::vector<double> x, y;
  for (const Point2& p : controls) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
  const std::vector<Cubic> xs = splineSpans(x, closed), ys = splineSpans(y, closed);
  PlaneCurve curve;
  for (std::size_t i = 0; i < xs.size(); ++i) curve.push_back({xs[i], ys[i]});
  return curve;
}

std::optional<Point2> findSharpPoint(const PlaneCurve& curve, double size) {
  constexpr double smallest = 1e-9;
  PlaneCurve parts;
  std::optional<Point2> sharp;
  for (const PlaneCubic& piece : curve) addGentleParts(piece, smallest * size, parts, sharp);
  return sharp;
}

std::optional<Point2> findSelfContact(const PlaneCurve& curve, bool closed, double gap) {
  PlaneCurve parts;
  std::optional<Point2> sharp;
  for (const PlaneCubic& piece : curve) addGentleParts(piece, 0, parts, sharp);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = i + 2; j < parts.size(); ++j) {
      if (closed && i == 0 && j + 1 == parts.size()) continue;  // these follow each other, too
      if (const auto contact = findContact(parts[i], parts[j], gap)) return contact;
    }
  }
  return std::nullopt;
}

bool comesNear(const PlaneCurve& curve, const Point2& point, double gap) {
  return std::any_of(curve.begin(), curve.end(), [&](const PlaneCubic& piece) {
    return findContact(piece, standing(point), gap).has_value();
  });
}

}  // namespace anamorph
