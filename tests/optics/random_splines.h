// Random mirrors of splines in any direction, and their surfaces by definition: what the tests of the three compare with.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "optics/extrusion.h"
#include "optics/patch.h"
#include "optics/revolution.h"
#include "random_scene.h"

namespace anamorph::testing {

inline RevolutionMirror randomRevolution(Random& random) {
  RevolutionMirror mirror;
  const Direction up = random.direction();
  mirror.bottom = random.point(5);
  mirror.top = mirror.bottom + random.uniform(2, 12) * up;
  mirror.radii.resize(static_cast<std::size_t>(random.integer(4, 14)));
  for (double& r : mirror.radii) r = random.uniform(0.5, 3.5);
  return mirror;
}

/// A wave, or a closed curve around its origin.
inline ExtrusionMirror randomExtrusion(Random& random) {
  ExtrusionMirror mirror;
  mirror.origin = random.point(5);
  mirror.axis = random.uniform(0.1, 3) * random.direction();
  mirror.across = random.uniform(0.1, 3) * random.direction();
  mirror.height = random.uniform(2, 10);
  mirror.closed = random.integer(0, 1) == 0;
  const int count = random.integer(mirror.closed ? 3 : 4, 20);
  mirror.points.clear();
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count, radius = random.uniform(2, 4);
    mirror.points.push_back(mirror.closed ? CurvePoint(radius * std::cos(angle), radius * std::sin(angle))
                                          : CurvePoint(i - 0.5 * count, random.uniform(-1, 1)));
  }
  return mirror;
}

inline PatchMirror randomPatch(Random& random) {
  PatchMirror mirror;
  mirror.origin = random.point(5);
  mirror.across = random.uniform(0.1, 3) * random.direction();
  mirror.up = random.uniform(0.1, 3) * random.direction();
  mirror.size = {random.uniform(3, 12), random.uniform(3, 12)};
  mirror.heights.columns = static_cast<std::size_t>(random.integer(4, 12));
  mirror.heights.heights.resize(mirror.heights.columns * static_cast<std::size_t>(random.integer(4, 12)));
  for (double& h : mirror.heights.heights) h = random.uniform(-1, 1);
  return mirror;
}

/// One of the three by turns.
inline Shape randomSpline(int number, Random& random) {
  if (number % 3 == 0) return randomRevolution(random);
  if (number % 3 == 1) return randomExtrusion(random);
  return randomPatch(random);
}

/// A point around the shape, from once to four times its size away.
inline Point randomEye(const Shape& shape, Random& random) {
  const Box box = boxOf(shape);
  return box.centre() + box.diagonal() * random.uniform(1, 4) * random.direction();
}

// ---- Places of their surfaces

/// A point of the surface and its outward normal.
struct Aim {
  Point point;
  Direction normal;
};
inline Aim aimAt(const Shape& shape, double u, double v) {
  if (const auto* mirror = shape.as<RevolutionMirror>())
    return {mirror->pointAt(u, v), mirror->normalAt(u, v)};
  if (const auto* mirror = shape.as<ExtrusionMirror>())
    return {mirror->pointAt(u, v), mirror->normalAt(u, v)};
  const auto& mirror = shapeAs<PatchMirror>(shape);
  return {mirror.pointAt(u, v), mirror.normalAt(u, v)};
}

// A direction at least 3 degrees out of the surface: along it, or any; now and then with components that are 0.
inline Direction wayTo(const Aim& aim, Random& random) {
  while (true) {
    Direction d = random.direction();
    if (random.integer(0, 4) == 0) d[random.integer(0, 2)] = 0;
    d = glm::normalize(d);
    if (isFinite(d) && std::abs(glm::dot(d, aim.normal)) > 0.05) return d;
  }
}

// ---- By definition

/// Blends of the four control values of a span.
inline std::array<double, 4> blends(double u) {
  const double v = 1 - u;
  return {v * v * v / 6, (3 * u * u * u - 6 * u * u + 4) / 6, (-3 * u * u * u + 3 * u * u + 3 * u + 1) / 6,
          u * u * u / 6};
}

struct SpanPlace {
  int span;
  double u;
};
inline SpanPlace spanOf(double position, int spans) {
  const int span = std::clamp(static_cast<int>(std::floor(position)), 0, spans - 1);
  return {span, position - span};
}

inline double radiusByDefinition(const RevolutionMirror& mirror, double h) {
  const int spans = static_cast<int>(mirror.radii.size()) - 3;
  const auto [span, u] = spanOf(h / mirror.height() * spans, spans);
  const auto b = blends(u);
  double r = 0;
  for (int i = 0; i < 4; ++i) r += b[std::size_t(i)] * mirror.radii[std::size_t(span + i)];
  return r;
}

inline CurvePoint curveByDefinition(const ExtrusionMirror& mirror, double position) {
  const int m = static_cast<int>(mirror.points.size()), spans = mirror.closed ? m : m - 3;
  const auto [span, u] = spanOf(position, spans);
  const auto b = blends(u);
  CurvePoint p(0);
  for (int i = 0; i < 4; ++i) p += b[std::size_t(i)] * mirror.points[std::size_t((span + i) % m)];
  return p;
}

inline double heightByDefinition(const PatchMirror& mirror, double x, double y) {
  const int columns = static_cast<int>(mirror.heights.columns) - 3;
  const int rows = static_cast<int>(mirror.heights.rows()) - 3;
  const auto [column, u] = spanOf(x / mirror.size[0] * columns, columns);
  const auto [row, v] = spanOf(y / mirror.size[1] * rows, rows);
  const auto bu = blends(u), bv = blends(v);
  double z = 0;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      z += bv[std::size_t(j)] * bu[std::size_t(i)] *
           mirror.heights.at(std::size_t(row + j), std::size_t(column + i));
    }
  }
  return z;
}

}  // namespace anamorph::testing
