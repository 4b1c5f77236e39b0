// The sculpture on its way from the original, ready to be drawn and reflected: morph.h with normals and tree.
// Kept as long as nothing changes.
#pragma once

#include "pipeline/buffer_ring.h"
#include "pipeline/memo.h"
#include "pipeline/moving_mesh.h"

namespace anamorph {

class MorphStage {
 public:
  /// `fraction`: t of morphPoints; 1 is the sculpture itself.
  PreparedSculpture at(double fraction, const LevelScene& level, const PreparedSculpture& sculpture,
                       int threads);

 private:
  struct Input {
    double fraction;
    VertexMap map;
    PreparedSculpture sculpture;
    bool operator==(const Input&) const = default;
  };
  PreparedSculpture make(const Input& input, int threads);

  Memo<Input, PreparedSculpture> memo_;
  std::shared_ptr<const NormalGroups> ringGroups_;  // of the triangles that the ring's buffers have
  BufferRing<MovingMesh> ring_;
};

}  // namespace anamorph
