#include "exports/self_crossings.h"

#include <algorithm>
#include <vector>

#include "base/parallel_for.h"
#include "exports/triangle_crossing.h"

namespace anamorph {
namespace {

constexpr std::size_t grain = 256, batch = 32 * grain;

TriangleCornerPoints cornersOf(const Mesh& mesh, std::uint32_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
}

bool shareCorner(const Triangle& s, const Triangle& t) {
  return std::any_of(s.begin(), s.end(),
                     [&](std::uint32_t corner) { return std::find(t.begin(), t.end(), corner) != t.end(); });
}

bool boxesApart(const Box& box, const BvhNode& node) {
  for (int axis = 0; axis < 3; ++axis) {
    if (box.max[axis] < node.min[axis] || box.min[axis] > node.max[axis]) return true;
  }
  return false;
}

// The crossings of one triangle with those of a larger number.
std::size_t countWith(const Mesh& mesh, const Bvh& bvh, std::uint32_t triangle) {
  const TriangleCornerPoints corners = cornersOf(mesh, triangle);
  Box box;
  for (const Point& p : corners) box.extend(p - bvh.centre());
  std::size_t count = 0;
  std::uint32_t stack[2 * 64];  // the tree is at most 64 levels deep
  int waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const BvhNode& node = bvh.nodes()[stack[--waiting]];
    if (boxesApart(box, node)) continue;
    if (node.count == 0) {
      stack[waiting++] = node.link;
      stack[waiting++] = node.link + 1;
      continue;
    }
    for (std::uint32_t i = node.link; i < node.link + node.count; ++i) {
      const std::uint32_t other = bvh.triangleOrder()[i];
      if (other > triangle && !shareCorner(mesh.triangles[triangle], mesh.triangles[other]) &&
          trianglesCross(corners, cornersOf(mesh, other))) {
        ++count;
      }
    }
  }
  return count;
}

Point middleOf(const TriangleCornerPoints& corners) {
  return (corners[0] + corners[1] + corners[2]) / 3.0;
}

}  // namespace

std::optional<SelfCrossings> countSelfCrossings(const Mesh& mesh, const Bvh& bvh, std::size_t limit,
                                                int threads, const Progress& progress) {
  SelfCrossings crossings;
  const std::size_t total = mesh.triangles.size();
  if (bvh.empty()) return crossings;
  std::vector<std::size_t> counts(batch);
  // In batches, so that where counting stops does not depend on the threads.
  for (std::size_t first = 0; first < total; first += batch) {
    const std::size_t size = std::min(batch, total - first);
    if (!progress.update(double(first) / double(total))) return std::nullopt;
    parallelFor(size, grain, threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress.cancelled(); ++i) {
        counts[i] = countWith(mesh, bvh, static_cast<std::uint32_t>(first + i));
      }
    });
    if (progress.cancelled()) return std::nullopt;
    for (std::size_t i = 0; i < size; ++i) {
      if (counts[i] > 0 && !crossings.example)
        crossings.example = middleOf(cornersOf(mesh, static_cast<std::uint32_t>(first + i)));
      crossings.pairs += counts[i];
    }
    crossings.more = crossings.pairs >= limit && first + size < total;
    if (crossings.more) break;
  }
  return crossings;
}

}  // namespace anamorph
