// What is wrong with a mesh that is to be printed and can be put right without asking: triangles that are there twice,
// and parts that are inside out. Slicers would take the first for a wall without thickness and the second for a hole.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace anamorph {

struct PrintRepairs {
  std::vector<std::uint32_t>
      doubled;  ///< triangles that are there already, with the same corners in the same order
  std::vector<std::uint32_t> turned;  ///< triangles of the parts that are inside out
  std::size_t turnedParts = 0;
};

/// The triangles that an earlier one equals, in their order. Corners are the same when their indices are: weld first.
std::vector<std::uint32_t> findDoubled(const std::vector<Triangle>& triangles);

/// Equal positions count as one.
PrintRepairs findRepairs(const Mesh& mesh);

struct PreparedPrint {
  Mesh mesh;
  std::vector<std::string> notes;  ///< what was wrong with it, in sentences
};

/// The mesh put right and what was done; as it is and what is wrong with it, where nothing may be changed because the
/// tolerance is off.
PreparedPrint prepareForPrint(Mesh mesh, bool mayChange);

}  // namespace anamorph
