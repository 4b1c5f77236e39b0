// A small model of the RT camera, to see in the 3D view where the eye is: a box with a lens hood whose
// opening is at the eye.
#pragma once

#include "math/frame.h"
#include "pipeline/memo.h"
#include "pipeline/stages.h"

namespace anamorph {

/// In scene coordinates, about 2 * size long, behind the eye; nothing for a camera that is nowhere.
PreparedMesh makeCameraModel(const Point& eye, const Frame& frame, double size);

/// The model, made anew only when it is elsewhere or of another size.
class CameraModel {
 public:
  const PreparedMesh& at(const Camera& camera, double size);
  /// How often it was made.
  int count() const { return count_; }

 private:
  struct Key {
    Point eye;
    Frame frame;
    double size;
    bool operator==(const Key&) const = default;
  };
  Memo<Key, PreparedMesh> memo_;
  int count_ = 0;
};

}  // namespace anamorph
