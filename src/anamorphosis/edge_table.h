// The edges of a set of triangles, each once: a hash table from a pair of vertices to a running number.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace anamorph {

struct EdgeTable {
  std::vector<std::array<std::uint32_t, 2>> ends;        ///< of every edge, smaller vertex first
  std::vector<std::array<std::uint32_t, 3>> ofTriangle;  ///< edge i joins corners i and i + 1
};

/// Edges are numbered in the order in which the listed triangles use them first.
EdgeTable makeEdgeTable(const std::vector<Triangle>& triangles, const std::vector<std::uint32_t>& listed);

}  // namespace anamorph
