// How the triangles of a surface hang together. Every edge of a sound solid has two triangles, which run
// through it in opposite directions, and around every corner its triangles form one fan:
//
//        sound            border          three or more        turned around        pinched
//       /|\              /|              /|\                  /|\                  \ | /
//      / v ^\           / |             / |-\-               / v v\                 \|/
//      \ | | /          \ |             \ |/ /               \ | | /                /|\   two fans that have
//       \|/              \|              \|/                  \|/                  / | \  a corner in common
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace anamorph {

struct SurfaceTopology {
  std::size_t borderEdges = 0;     ///< used by one triangle
  std::size_t crowdedEdges = 0;    ///< used by three or more
  std::size_t turnedEdges = 0;     ///< used by two triangles in the same direction
  std::size_t pinchedCorners = 0;  ///< where more than one fan of triangles meets

  /// Whether slicers can tell inside from outside.
  bool isSound() const { return borderEdges + crowdedEdges + turnedEdges + pinchedCorners == 0; }
};

/// A part of the surface without a common edge with others.
struct Shell {
  std::vector<std::uint32_t> triangles;
  bool isClosed = false;  ///< all of its edges are sound
  double volume = 0;      ///< of a closed one: negative when its triangles face inwards
};

struct Surface {
  SurfaceTopology topology;
  std::vector<Shell> shells;  ///< in the order of their first triangles
};

/// Corners are the same when their indices are: weld first.
Surface measureSurface(const Mesh& mesh);

}  // namespace anamorph
