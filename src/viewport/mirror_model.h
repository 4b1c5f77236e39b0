// The mirror as triangles, when its shape has no shader of its own: made once for a shape, and moved while only its place
// changes. Fine enough that a picture does not tell it from the exact surface.
#pragma once

#include <memory>
#include <vector>

#include "optics/optic.h"
#include "pipeline/memo.h"
#include "pipeline/stages.h"
#include "viewport/viewport_input.h"

namespace anamorph {

/// All pointers null: there is none.
struct MirrorTriangles {
  PreparedMesh prepared;
  std::shared_ptr<const std::vector<float>>
      borders;  ///< of every normal's corner, as the whole shape's borderDistance()
};

class MirrorModel {
 public:
  /// Of the mirror that this input shows.
  const MirrorTriangles& at(const ViewportInput& input);
  /// How often a tree was built.
  int count() const { return count_; }

 private:
  MirrorTriangles make(const Shape& shape);

  Memo<Shape, MirrorTriangles> memo_;
  MirrorTriangles last_;  // made before, to be moved
  int count_ = 0;
};

}  // namespace anamorph
