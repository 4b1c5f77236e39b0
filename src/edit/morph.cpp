#include "edit/morph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/parallel_for.h"
#include "optics/exit_points.h"

namespace anamorph {
namespace {

Point alongWay(const Point& p, const Point& q, const Point& s, double t) {
  const double in = glm::length(q - p), out = glm::length(s - q), gone = t * (in + out);
  if (gone < in) return p + (gone / in) * (q - p);
  return out > 0 ? q + ((gone - in) / out) * (s - q) : s;
}

// Where the vertex ray of a point that is not plain (exit_points.h) meets the mirror; the point itself if
// nowhere.
Point mirrorPoint(const Optic& optic, const Point& eye, const Point& original) {
  if (!(lengthSquared(original - eye) > 0)) return original;
  const OpticPath path = followRay(optic, {eye, original - eye});
  return path.pointCount > 0 ? path.points[static_cast<std::size_t>(path.pointCount - 1)] : original;
}

// The mirror points are exit points of depth 0; without a mirror the way is straight. `result` holds the
// sculpture and takes the points on their way.
void morphRange(const Sculpture& sculpture, const Optic& optic, const Point& eye, double t,
                PointArray& result, std::size_t begin, std::size_t end) {
  const PointArray& in = sculpture.original;
  const bool straight = optic.kind == OpticKind::none;
  std::array<std::int64_t, exitBlockSize> plain;
  std::array<double, exitBlockSize> qx, qy, qz;
  for (std::size_t first = begin; first < end; first += exitBlockSize) {
    const std::size_t count = std::min(exitBlockSize, end - first);
    exitPoints(optic, eye, 0, {&in.x[first], &in.y[first], &in.z[first]}, count,
               {qx.data(), qy.data(), qz.data()}, plain.data());
    for (std::size_t i = 0; i < count; ++i) {
      if (sculpture.status[first + i] != PathStatus::mapped) continue;
      const Point p = in[first + i];
      const Point q = plain[i] ? Point(qx[i], qy[i], qz[i]) : mirrorPoint(optic, eye, p);
      const Point s = result[first + i];
      result.set(first + i, straight ? glm::mix(p, s, t) : alongWay(p, q, s, t));
    }
  }
}

}  // namespace

PointArray morphPoints(const Sculpture& sculpture, const Optic& optic, const Point& eye, double t,
                       int threads) {
  if (!(t > 0)) return sculpture.original;
  PointArray result = sculpture.mesh.positions;
  if (t >= 1) return result;
  constexpr std::size_t grain = 16 * exitBlockSize;
  parallelFor(result.size(), grain, threads, [&](std::size_t begin, std::size_t end) {
    morphRange(sculpture, optic, eye, t, result, begin, end);
  });
  return result;
}

}  // namespace anamorph
