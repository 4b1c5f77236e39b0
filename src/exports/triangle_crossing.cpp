#include "exports/triangle_crossing.h"

#include <algorithm>
#include <cmath>

namespace anamorph {
namespace {

// (7 + 56 e) e of Shewchuk's orient3d, with e = 2^-53.
constexpr double volumeError = 7.7715611723761027e-16;
// (3 + 16 e) e of his orient2d.
constexpr double areaError = 3.3306690738754716e-16;

using Sides = std::array<int, 3>;

Sides sidesOf(const TriangleCornerPoints& plane, const TriangleCornerPoints& corners) {
  Sides sides;
  for (int i = 0; i < 3; ++i) sides[i] = sideOf(plane[0], plane[1], plane[2], corners[i]);
  return sides;
}

bool areApart(const Sides& s) {
  return (s[0] >= 0 && s[1] >= 0 && s[2] >= 0) || (s[0] <= 0 && s[1] <= 0 && s[2] <= 0);
}

// Whether an edge of `edges` passes through `t` from one side of it to the other.
bool edgePassesThrough(const TriangleCornerPoints& edges, const Sides& sides, const TriangleCornerPoints& t) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (sides[i] * sides[j] >= 0) continue;
    const Point &p = edges[i], &q = edges[j];
    const int a = sideOf(p, q, t[0], t[1]), b = sideOf(p, q, t[1], t[2]), c = sideOf(p, q, t[2], t[0]);
    if ((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0)) return true;
  }
  return false;
}

using Flat = std::array<glm::dvec2, 3>;

int turnOf(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
  const double area = left - right, error = areaError * (std::abs(left) + std::abs(right));
  return area > error ? 1 : area < -error ? -1 : 0;
}

// Triangles without a common area have a line between them along an edge of one.
bool flatOverlap(const Flat& s, const Flat& t) {
  const int turn = turnOf(s[0], s[1], s[2]);
  if (turn == 0 || turnOf(t[0], t[1], t[2]) == 0) return false;
  for (int i = 0; i < 3; ++i) {
    const auto outside = [&](const glm::dvec2& p) { return turnOf(s[i], s[(i + 1) % 3], p) * turn <= 0; };
    if (std::all_of(t.begin(), t.end(), outside)) return false;
  }
  return true;
}

// Seen along the axis in which the common plane is seen largest.
bool coplanarOverlap(const TriangleCornerPoints& s, const TriangleCornerPoints& t) {
  const Vector n = glm::abs(glm::cross(s[1] - s[0], s[2] - s[0]));
  const int z = n.x >= n.y && n.x >= n.z ? 0 : n.y >= n.z ? 1 : 2, x = (z + 1) % 3, y = (z + 2) % 3;
  Flat flatS, flatT;
  for (int i = 0; i < 3; ++i) {
    flatS[i] = {s[i][x], s[i][y]};
    flatT[i] = {t[i][x], t[i][y]};
  }
  return flatOverlap(flatS, flatT) && flatOverlap(flatT, flatS);
}

}  // namespace

int sideOf(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Vector u = a - d, v = b - d, w = c - d;
  const double vw = v.x * w.y, wv = w.x * v.y, wu = w.x * u.y, uw = u.x * w.y, uv = u.x * v.y, vu = v.x * u.y;
  const double volume = u.z * (vw - wv) + v.z * (wu - uw) + w.z * (uv - vu);
  const double size = (std::abs(vw) + std::abs(wv)) * std::abs(u.z) +
                      (std::abs(wu) + std::abs(uw)) * std::abs(v.z) +
                      (std::abs(uv) + std::abs(vu)) * std::abs(w.z);
  const double error = volumeError * size;
  return volume < -error ? 1 : volume > error ? -1 : 0;
}

bool trianglesCross(const TriangleCornerPoints& s, const TriangleCornerPoints& t) {
  const Sides ofT = sidesOf(s, t);
  if (ofT == Sides{0, 0, 0}) return coplanarOverlap(s, t);
  if (areApart(ofT)) return false;
  const Sides ofS = sidesOf(t, s);
  if (areApart(ofS)) return false;
  return edgePassesThrough(s, ofS, t) || edgePassesThrough(t, ofT, s);
}

}  // namespace anamorph
