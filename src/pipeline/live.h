// The frame of a drag: original and sculpture follow, their triangles stay. No refinement, no new trees:
// points are mapped again, normals computed again, trees refitted. What is refined (evaluator.h) comes after the
// drag, from the worker.
//
//   Level ----> LiveOriginal::place ----> LiveSculpture::follow ----> what the 3D view and the tracer show
#pragma once

#include <memory>
#include <vector>

#include "pipeline/buffer_ring.h"
#include "pipeline/moving_mesh.h"

namespace anamorph {

class LiveOriginal {
 public:
  /// `shape` is the level's own original before it is placed, `placed` the same mesh prepared at any
  /// placement.
  LiveOriginal(std::shared_ptr<const Mesh> shape, PreparedMesh placed);

  /// As prepareMesh(placeOriginal(...)), but for the last bits of the normals and the shape of the tree.
  PreparedMesh place(bool unitized, const Placement& placement, int threads);

 private:
  std::shared_ptr<const Mesh> shape_;
  std::shared_ptr<const Mesh> unitized_;  // made when it is asked for
  PreparedMesh start_;
  std::vector<glm::vec3> shapeNormals_;
  MovingMesh prototype_;
  BufferRing<MovingMesh> ring_;
};

class LiveSculpture {
 public:
  /// Keeps the triangles of `settled` when every vertex of the original is mapped in it. Otherwise some are
  /// missing there that may come into view, and the original's own triangles are taken, unrefined.
  LiveSculpture(const PreparedMesh& original, const PreparedSculpture& settled);

  /// The sculpture of a changed map, for a level without findProblem; `original` is placed, with the triangles of the
  /// constructor's. Triangles with an unmapped corner are still in the mesh, but not in the tree: their
  /// corners' status tells. The winding is that of the triangles kept, and what is folded now is told when it is settled.
  PreparedSculpture follow(const VertexMap& map, const std::shared_ptr<const Mesh>& original, int threads);

 private:
  struct Buffer {
    MovingMesh moving;
    std::shared_ptr<const Mesh> original;  // that sculpture.original was taken from
  };

  bool ownTriangles_;
  std::shared_ptr<const NormalGroups> normalGroups_;
  Buffer prototype_;
  BufferRing<Buffer> ring_;
};

}  // namespace anamorph
