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

#include "geometry/mesh.h"

namespace anamorph {

struct SurfaceTopology {
  std::size_t borderEdges = 0;     ///< used by one triangle
  std::size_t crowdedEdges = 0;    ///< used by three or more
  std::size_t turnedEdges = 0;     ///< used by two triangles in the same direction
  std::size_t pinchedCorners = 0;  ///< where more than one fan of triangles meets
  std::size_t shells = 0;          ///< parts without a common edge
  std::size_t inwardShells = 0;    ///< of those, closed ones whose signed volume is negative

  /// Whether slicers can tell inside from outside.
  bool isSound() const { return borderEdges + crowdedEdges + turnedEdges + pinchedCorners == 0; }
};

/// Corners are the same when their indices are: weld first.
SurfaceTopology measureTopology(const Mesh& mesh);

}  // namespace anamorph
