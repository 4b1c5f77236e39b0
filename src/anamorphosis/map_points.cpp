#include "anamorphosis/map_points.h"

#include <algorithm>
#include <cstring>

#include "base/parallel_for.h"

namespace anamorph {
namespace {

void mapRange(const VertexMap& map, const PointArray& in, MappedPoints& out, std::size_t begin,
              std::size_t end) {
  std::array<std::int64_t, exitBlockSize> plain;
  for (std::size_t first = begin; first < end; first += exitBlockSize) {
    const std::size_t count = std::min(exitBlockSize, end - first);
    std::size_t plainCount = 0;
    if (map.mistakes.any()) {
      plain.fill(0);  // the batch knows the right formulas only
    } else {
      plainCount = exitPoints(map.optic, {map.eye,
                                          map.depthScale,
                                          map.depthOffset,
                                          {&in.x[first], &in.y[first], &in.z[first]},
                                          count,
                                          {&out.points.x[first], &out.points.y[first], &out.points.z[first]},
                                          plain.data()});
    }
    std::memset(&out.status[first], static_cast<int>(PathStatus::mapped), count);
    if (plainCount == count) continue;
    for (std::size_t i = 0; i < count; ++i) {
      if (plain[i]) continue;
      const MappedPoint mapped = mapPoint(map, in[first + i]);
      out.points.set(first + i, mapped.point);
      out.status[first + i] = mapped.status;
    }
  }
}

}  // namespace

void mapPointsThrough(const VertexMap& map, const PointArray& original, MappedPoints& result, int threads) {
  result.points.resize(original.size());
  result.status.resize(original.size());
  const std::size_t grain = (hasBatch(map.optic) ? 64 : 1) * exitBlockSize;
  parallelFor(original.size(), grain, threads,
              [&](std::size_t begin, std::size_t end) { mapRange(map, original, result, begin, end); });
}

StatusCounts countStatus(const std::vector<PathStatus>& status) {
  StatusCounts counts{};
  for (const PathStatus s : status) ++counts[static_cast<std::size_t>(s)];
  return counts;
}

}  // namespace anamorph
