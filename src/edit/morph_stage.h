// The sculpture on its way from the original, ready to be drawn and reflected: morph.h with normals and tree.
// Kept as long as nothing changes. A large one is made by a worker, and what is shown follows as fast as that can.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "pipeline/buffer_ring.h"
#include "pipeline/memo.h"
#include "pipeline/moving_mesh.h"
#include "pipeline/worker.h"

namespace anamorph {

class MorphStage {
 public:
  /// `wake` is called from the worker's thread when there is something new to show.
  explicit MorphStage(std::function<void()> wake = {});

  /// `fraction`: t of morphPoints; 1 is the sculpture itself. Of a large sculpture the last state that is made.
  PreparedSculpture at(double fraction, const LevelScene& level, const PreparedSculpture& sculpture,
                       int threads);

  /// Whether what was asked for last is still being made.
  bool busy() const { return busy_; }

  /// Sculptures with more vertices are large.
  static constexpr std::size_t vertexLimit = 50'000;

 private:
  struct Input {
    double fraction;
    VertexMap map;
    PreparedSculpture sculpture;
    bool operator==(const Input&) const = default;
  };
  struct State {
    Input input;
    PreparedSculpture made;
  };
  /// Each thread has one of its own.
  class Maker {
   public:
    PreparedSculpture make(const Input& input, int threads);

   private:
    std::shared_ptr<const NormalGroups> ringGroups_;  // of the triangles that the ring's buffers have
    BufferRing<MovingMesh> ring_;
  };

  PreparedSculpture follow(Input input, int threads);

  Memo<Input, PreparedSculpture> memo_;
  Maker maker_;
  std::optional<State> shown_;               // of the worker's
  std::optional<Input> requested_, failed_;  // of the worker
  bool busy_ = false;
  std::shared_ptr<Maker> workersMaker_ = std::make_shared<Maker>();
  std::shared_ptr<Mailbox<State>> states_ = std::make_shared<Mailbox<State>>();
  Worker worker_;  // last: its jobs use the two above
};

}  // namespace anamorph
