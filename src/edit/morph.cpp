#include "edit/morph.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/parallel_for.h"

namespace anamorph {
namespace {

// From P by way of Q towards S, so far, and no farther than S.
Point alongWay(const Point& p, const Point& q, const Point& s, double gone) {
  const double in = glm::length(q - p), out = glm::length(s - q);
  if (gone < in) return p + (gone / in) * (q - p);
  return gone < in + out ? q + ((gone - in) / out) * (s - q) : s;
}

// The last point of the vertex ray on the optic; the point itself where there is none, or the way is straight.
Point mirrorPoint(const VertexMap& map, const Point& original) {
  if (!(lengthSquared(original - map.eye) > 0)) return original;
  const OpticPath path = followRay(map.optic, {map.eye, original - map.eye});
  return path.pointCount > 0 && path.bends ? path.exit.origin : original;
}

// Of all vertices of a range. The mirror points are exit points of depth 0.
void findMirrorPoints(const Sculpture& sculpture, const VertexMap& map, PointArray& result, std::size_t begin,
                      std::size_t end) {
  const PointArray& in = sculpture.original;
  std::array<std::int64_t, exitBlockSize> plain;
  std::array<double, exitBlockSize> qx, qy, qz;
  for (std::size_t first = begin; first < end; first += exitBlockSize) {
    const std::size_t count = std::min(exitBlockSize, end - first);
    exitPoints(map.optic, {map.eye,
                           0,
                           0,
                           {&in.x[first], &in.y[first], &in.z[first]},
                           count,
                           {qx.data(), qy.data(), qz.data()},
                           plain.data()});
    for (std::size_t i = 0; i < count; ++i) {
      if (sculpture.status[first + i] != PathStatus::mapped) continue;
      result.set(first + i, plain[i] ? Point(qx[i], qy[i], qz[i]) : mirrorPoint(map, in[first + i]));
    }
  }
}

double longestWay(const Sculpture& sculpture, const PointArray& mirrorPoints) {
  double longest = 0;
  for (std::size_t i = 0; i < mirrorPoints.size(); ++i) {
    if (sculpture.status[i] != PathStatus::mapped) continue;
    const Point q = mirrorPoints[i];
    longest = std::max(longest,
                       glm::length(q - sculpture.original[i]) + glm::length(sculpture.mesh.positions[i] - q));
  }
  return longest;
}

}  // namespace

PointArray morphPoints(const Sculpture& sculpture, const VertexMap& map, double t, int threads) {
  if (!(t > 0)) return sculpture.original;
  if (t >= 1) return sculpture.mesh.positions;
  constexpr std::size_t grain = 16 * exitBlockSize;
  PointArray mirrorPoints = sculpture.original;
  parallelFor(mirrorPoints.size(), grain, threads, [&](std::size_t begin, std::size_t end) {
    findMirrorPoints(sculpture, map, mirrorPoints, begin, end);
  });
  const double gone = t * longestWay(sculpture, mirrorPoints);
  PointArray result = sculpture.mesh.positions;
  parallelFor(result.size(), grain, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (sculpture.status[i] != PathStatus::mapped) continue;
      result.set(i, alongWay(sculpture.original[i], mirrorPoints[i], result[i], gone));
    }
  });
  return result;
}

}  // namespace anamorph
