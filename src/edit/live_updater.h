// Keeps what is shown of the session's level up to date. While something moves, the sculpture, a coarse
// preview and the rays follow in the frame (pipeline/live.h); when it rests, the worker refines, matches and
// takes the pictures (pipeline/evaluator.h), and hands over what it has step by step. No call here waits for the
// worker.
//
//   session.level() --changed?--> live step, in the frame ----------------------> products()
//                  \--at rest----> worker: settle ... part ... part ... complete --^
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "edit/session.h"
#include "pipeline/evaluator.h"
#include "pipeline/live.h"
#include "pipeline/memo.h"
#include "pipeline/worker.h"
#include "raytrace/tracer.h"

namespace anamorph {

/// What the window shows. Everything belongs to `level`; pointers are null when there is nothing yet.
struct Products {
  Level level;
  std::shared_ptr<const Mesh> shape;
  PreparedMesh original;
  PreparedSculpture sculpture;
  std::optional<std::string> problem;  ///< why there is no sculpture, and what to do
  std::vector<std::string> warnings;
  std::shared_ptr<const Match> match;
  Previews previews;
  bool refined = false;   ///< the sculpture is the settled one
  bool complete = false;  ///< match and pictures are too

  std::shared_ptr<const RenderScene> scene;           ///< what the RT camera sees
  std::shared_ptr<const Image> screen;                ///< one pixel for every cell of the pixel grid
  std::shared_ptr<const std::vector<RayTree>> trees;  ///< of every cell, row by row; null unless asked for
};

struct UpdateOptions {
  int previewSize = 256;  ///< longer side in pixels; 0: the pixel grid's own resolution
  bool trees = false;     ///< whether the ray trees of the pixel grid are wanted
  bool original =
      true;  ///< whether the original's and the difference picture are wanted while something moves
};

/// Milliseconds of the last update that worked on a level that moves.
struct LiveTimes {
  double original = 0, sculpture = 0, preview = 0, match = 0, rays = 0;
  double total() const { return original + sculpture + preview + match + rays; }
};

class LiveUpdater {
 public:
  /// `wake` is called from the worker's thread when there is something new to take. `threads` <= 0: all.
  explicit LiveUpdater(std::function<void()> wake = {}, int threads = 0);

  /// One frame. Returns whether the products changed.
  bool update(const Session& session, const UpdateOptions& options);
  const Products& products() const { return products_; }

  /// Whether the worker works, or will when the level has rested for a moment.
  bool busy() const;
  /// How far the worker is, 0..1.
  double fraction() const { return worker_.fraction(); }
  /// Seconds until update() has something to start though nothing has happened; nothing when it has not.
  std::optional<double> secondsUntilDue() const;
  /// Stops the worker; what is missing stays missing until the level changes.
  void cancel();
  /// Begins anew what was cancelled.
  void restart();

  /// update() until all is complete or has failed, for screenshots and tests.
  void finish(const Session& session, const UpdateOptions& options);

  const LiveTimes& liveTimes() const { return liveTimes_; }

  /// The longer side of pictures and match while something moves, in pixels.
  static constexpr int coarseSize = 40;
  /// More vertices than this do not follow in the frame but on the worker.
  static constexpr std::size_t liveVertexLimit = 200'000;

 private:
  using Clock = std::chrono::steady_clock;

  void openLevel(const Session& session);
  bool takeResults(const Session& session);
  void adopt(const Settled& settled, bool current);
  void followLevel(const Level& level, const UpdateOptions& options);
  void followSculpture(const Level& level);
  std::shared_ptr<const RenderScene> sceneOf(const Level& level);
  void takeCoarsePictures(const Level& level, bool original);
  void request(const Session& session, const UpdateOptions& options);
  bool updateRays(const UpdateOptions& options);
  bool large() const;

  int threads_, frameThreads_;
  Products products_;
  int generation_ = 0;
  LiveTimes liveTimes_;

  std::shared_ptr<const Mesh> liveShape_;  // that liveOriginal_ was made from
  std::optional<LiveOriginal> liveOriginal_;
  PreparedMesh baseOriginal_;  // settled, that live ones start from
  PreparedSculpture baseSculpture_;
  std::optional<LiveSculpture> liveSculpture_;
  struct GridKey {
    std::shared_ptr<const RenderScene> scene;
    Camera camera;
    ImageRequest request;
    bool operator==(const GridKey&) const = default;
  };
  Memo<SceneInput, std::shared_ptr<const RenderScene>> scene_;
  Memo<GridKey, std::shared_ptr<const Image>> screen_;
  Memo<GridKey, std::shared_ptr<const std::vector<RayTree>>> trees_;

  std::optional<EvaluationInput> requested_;
  Clock::time_point lastChange_{};
  bool resting_ = false;  // a change goes on, but has not moved for a while
  bool cancelled_ = false;

  const std::function<void()> wake_;
  std::shared_ptr<Evaluator> evaluator_ = std::make_shared<Evaluator>();
  std::shared_ptr<Mailbox<Settled>> results_ = std::make_shared<Mailbox<Settled>>();
  Worker worker_;  // last: its job uses the mailbox
};

}  // namespace anamorph
