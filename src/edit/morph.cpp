#include "edit/morph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "base/parallel_for.h"

namespace anamorph {
namespace {

Point alongWay(const Point& p, const Point& q, const Point& s, double t) {
  const double in = glm::length(q - p), out = glm::length(s - q), gone = t * (in + out);
  if (gone < in) return p + (gone / in) * (q - p);
  return out > 0 ? q + ((gone - in) / out) * (s - q) : s;
}

// The last point of the vertex ray on the optic; the point itself if nowhere. Nothing where the way is straight.
std::optional<Point> mirrorPoint(const VertexMap& map, const Point& original) {
  if (!(lengthSquared(original - map.eye) > 0)) return original;
  const OpticPath path = followRay(map.optic, {map.eye, original - map.eye});
  if (path.pointCount == 0) return original;
  return path.bends ? std::optional(path.exit.origin) : std::nullopt;
}

// The mirror points are exit points of depth 0. `result` holds the sculpture and takes the points on their way.
void morphRange(const Sculpture& sculpture, const VertexMap& map, double t, PointArray& result,
                std::size_t begin, std::size_t end) {
  const PointArray& in = sculpture.original;
  std::array<std::int64_t, exitBlockSize> plain;
  std::array<double, exitBlockSize> qx, qy, qz;
  for (std::size_t first = begin; first < end; first += exitBlockSize) {
    const std::size_t count = std::min(exitBlockSize, end - first);
    exitPoints(map.optic, {map.eye,
                           0,
                           {&in.x[first], &in.y[first], &in.z[first]},
                           count,
                           {qx.data(), qy.data(), qz.data()},
                           plain.data()});
    for (std::size_t i = 0; i < count; ++i) {
      if (sculpture.status[first + i] != PathStatus::mapped) continue;
      const Point p = in[first + i];
      const auto q = plain[i] ? std::optional(Point(qx[i], qy[i], qz[i])) : mirrorPoint(map, p);
      const Point s = result[first + i];
      result.set(first + i, q ? alongWay(p, *q, s, t) : glm::mix(p, s, t));
    }
  }
}

}  // namespace

PointArray morphPoints(const Sculpture& sculpture, const VertexMap& map, double t, int threads) {
  if (!(t > 0)) return sculpture.original;
  PointArray result = sculpture.mesh.positions;
  if (t >= 1) return result;
  constexpr std::size_t grain = 16 * exitBlockSize;
  parallelFor(result.size(), grain, threads,
              [&](std::size_t begin, std::size_t end) { morphRange(sculpture, map, t, result, begin, end); });
  return result;
}

}  // namespace anamorph
