// Keeps what is shown of the session's level up to date. While something moves, the sculpture, a coarse
// preview and the rays follow in the frame (pipeline/live.h); when it rests, the worker refines, matches and
// takes the pictures (pipeline/evaluator.h), and hands over what it has step by step. No call here waits for the
// worker.
//
//   session.level() --changed?--> live step, in the frame ----------------------> result()
//                  \--at rest----> worker: evaluate ... part ... part ... complete --^
//
// The live step is keyed by value like the worker's stages: what does not depend on the change is kept. A light's
// colour costs a coarse picture; no vertex is mapped, no tree refitted, nothing matched, nothing sent to the
// graphics card.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "edit/session.h"
#include "pipeline/evaluator.h"
#include "pipeline/live.h"
#include "pipeline/memo.h"
#include "pipeline/worker.h"

namespace anamorph {

struct UpdateOptions {
  int previewSize = 256;  ///< longer side in pixels; 0: the pixel grid's own resolution
  bool trees = false;     ///< whether the ray trees of the pixel grid are wanted
  /// Whether the original's and the difference picture are wanted while something moves.
  bool original = true;
};

/// Milliseconds of the last update that worked on a level that moves.
struct LiveTimes {
  double original = 0, sculpture = 0, preview = 0, match = 0, rays = 0;
  double total() const { return original + sculpture + preview + match + rays; }
};

/// How often the live step has computed each of its stages.
struct LiveCounts {
  std::size_t originals = 0, sculptures = 0, matches = 0, pictures = 0;
  bool operator==(const LiveCounts&) const = default;
};

class LiveUpdater {
 public:
  /// `wake` is called from the worker's thread when there is something new to take. `threads` <= 0: all.
  explicit LiveUpdater(std::function<void()> wake = {}, int threads = 0);

  /// One frame. Returns whether the result changed.
  bool update(const Session& session, const UpdateOptions& options);
  const LevelResult& result() const { return result_; }

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
  const LiveCounts& liveCounts() const { return liveCounts_; }

  /// The longer side of pictures and match while something moves, in pixels.
  static constexpr int coarseSize = 40;
  /// Original and sculpture with more vertices than this for each thread of a frame follow on the worker.
  static constexpr std::size_t liveVerticesPerThread = 25'000;

 private:
  using Clock = std::chrono::steady_clock;

  void openLevel(const Session& session);
  void forget(const Level& level);
  bool takeResults(const Session& session);
  void take(LevelResult evaluated);
  void noteSculpture();
  void followLevel(const Level& level, const UpdateOptions& options);
  void followOriginal(const LevelScene& before);
  void followSource(const SculptureInputs& before);
  void followSculpture();
  void takeCoarsePictures(bool wantOriginal, bool compare);
  void followMatch(bool compare);
  void makeScene();
  void request(const Session& session, const UpdateOptions& options);
  bool updateRays(const UpdateOptions& options);
  bool large() const;

  // What a picture shows, whatever its size; the pixel grid's sides are its proportions.
  struct PictureSubject {
    SceneInput scene;
    Camera camera;
    int columns, rows;
    TracingSettings tracing;
    bool operator==(const PictureSubject&) const = default;
  };
  // What a match compares, whatever its size.
  struct MatchSubject {
    PreparedMesh original;
    PreparedSculpture sculpture;
    Optic optic;
    Camera camera;
    int columns, rows;
    GroundSettings ground;
    bool operator==(const MatchSubject&) const = default;
  };
  struct SculptureSubject {
    std::shared_ptr<const Mesh> original;
    VertexMap map;
    bool operator==(const SculptureSubject&) const = default;
  };
  // What the parts of the result are of; nothing: of nothing that could be kept.
  struct Subjects {
    std::optional<OriginalShape> shape;
    std::optional<SculptureSubject> sculpture;
    std::optional<std::string> emptiness;  // of that sculpture
    std::optional<DeformInput> refined;
    std::optional<MatchSubject> match;
    std::optional<PictureSubject> reflection, original;
  };
  PictureSubject reflectionSubject() const;
  PictureSubject originalSubject() const;
  MatchSubject matchSubject() const;

  int threads_, frameThreads_;
  LevelResult result_;
  Subjects of_;
  int generation_ = 0;
  LiveTimes liveTimes_;
  LiveCounts liveCounts_;

  std::shared_ptr<const Mesh> liveShape_;  // that liveOriginal_ was made from
  std::optional<LiveOriginal> liveOriginal_;
  PreparedMesh baseOriginal_;  // evaluated, that live ones start from
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

  struct Evaluated {
    EvaluationInput input;
    LevelResult result;
  };
  const std::function<void()> wake_;
  std::shared_ptr<Evaluator> evaluator_ = std::make_shared<Evaluator>();
  std::shared_ptr<Mailbox<Evaluated>> results_ = std::make_shared<Mailbox<Evaluated>>();
  Worker worker_;  // last: its job uses the mailbox
};

}  // namespace anamorph
