#include "anamorphosis/edge_table.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace anamorph {

EdgeTable makeEdgeTable(const std::vector<Triangle>& triangles, const std::vector<std::uint32_t>& listed) {
  // Open addressing: at most 3 edges a triangle, so twice the next power of two stays half empty.
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  const std::size_t slots = std::bit_ceil(std::max<std::size_t>(16, listed.size() * 6));
  std::vector<std::uint32_t> slot(slots, none);
  EdgeTable table;
  table.ofTriangle.reserve(listed.size());
  for (const std::uint32_t triangle : listed) {
    const Triangle& t = triangles[triangle];
    std::array<std::uint32_t, 3> edges{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t p = t[i], q = t[(i + 1) % 3];
      const std::array<std::uint32_t, 2> ends{std::min(p, q), std::max(p, q)};
      std::uint64_t hash = (std::uint64_t{ends[0]} << 32 | ends[1]) * 0x9E3779B97F4A7C15u;
      std::size_t at = (hash ^ hash >> 29) & (slots - 1);
      while (slot[at] != none && table.ends[slot[at]] != ends) at = (at + 1) & (slots - 1);
      if (slot[at] == none) {
        slot[at] = static_cast<std::uint32_t>(table.ends.size());
        table.ends.push_back(ends);
      }
      edges[i] = slot[at];
    }
    table.ofTriangle.push_back(edges);
  }
  return table;
}

}  // namespace anamorph
