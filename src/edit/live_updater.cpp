#include "edit/live_updater.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "base/parallel_for.h"
#include "level/freeze.h"
#include "raytrace/render.h"

namespace anamorph {
namespace {

constexpr double restSeconds = 0.25;   // a drag that pauses this long gets its settled state
constexpr int maxSampledCells = 1024;  // a pixel grid with more cells gets one ray each

class Stopwatch {
 public:
  explicit Stopwatch(double& milliseconds) : milliseconds_(milliseconds) {}
  ~Stopwatch() {
    milliseconds_ =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& milliseconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::shared_ptr<const Image> shared(std::optional<Image> image) {
  return image ? std::make_shared<const Image>(std::move(*image)) : nullptr;
}

}  // namespace

LiveUpdater::LiveUpdater(std::function<void()> wake, int threads)
    : threads_(threads > 0 ? threads : hardwareThreads()),
      frameThreads_(std::min(threads_, 4)),
      wake_(wake),
      worker_(std::move(wake)) {}

bool LiveUpdater::large() const {
  const std::size_t most = liveVerticesPerThread * static_cast<std::size_t>(frameThreads_);
  const auto& sculpture = baseSculpture_.sculpture;
  return (result_.shape && result_.shape->positions.size() > most) ||
         (sculpture && sculpture->mesh.positions.size() > most);
}

bool LiveUpdater::update(const Session& session, const UpdateOptions& options) {
  bool changed = false;
  if (session.generation() != generation_) {
    openLevel(session);
    changed = true;
  }
  changed |= takeResults(session);
  const bool moved = !isSameScene(result_.level, session.level());
  if (moved || !(result_.level.text == session.level().text)) restart();
  if (moved) {
    lastChange_ = Clock::now();
    if (session.changing() && !large()) {
      worker_.cancel();
      requested_.reset();
    }
    followLevel(session.level(), options);
    changed = true;
  }
  result_.level.text = session.level().text;
  request(session, options);
  double rayTime = 0;
  {
    const Stopwatch watch(rayTime);
    changed |= updateRays(options);
  }
  if (moved) liveTimes_.rays = rayTime;
  return changed;
}

void LiveUpdater::openLevel(const Session& session) {
  generation_ = session.generation();
  worker_.cancel();
  // The running job keeps the old ones until it notices. And a file that is opened again is read again.
  evaluator_ = std::make_shared<Evaluator>();
  results_ = std::make_shared<Mailbox<Evaluated>>();
  requested_.reset();
  cancelled_ = false;
  forget(session.level());
}

void LiveUpdater::forget(const Level& level) {
  result_ = {};
  result_.level = level;
  of_ = {};
  liveOriginal_.reset();
  liveShape_.reset();
  liveSculpture_.reset();
  baseOriginal_ = {};
  baseSculpture_ = {};
}

LiveUpdater::PictureSubject LiveUpdater::reflectionSubject() const {
  const LevelScene& level = result_.level;
  return {result_.scene->input, level.camera, level.grid.columns, level.grid.rows, level.tracing};
}
LiveUpdater::PictureSubject LiveUpdater::originalSubject() const {
  const LevelScene& level = result_.level;
  return {makeOriginalScene(level, result_.original), level.camera, level.grid.columns, level.grid.rows,
          level.tracing};
}
LiveUpdater::MatchSubject LiveUpdater::matchSubject() const {
  const LevelScene& level = result_.level;
  return {result_.original,   result_.sculpture, level.optic, level.camera,
          level.grid.columns, level.grid.rows,   level.ground};
}

// What is not current is a new start for the live step, which follows at once.
bool LiveUpdater::takeResults(const Session& session) {
  bool changed = false;
  if (auto evaluated = results_->take(); evaluated && evaluated->input.levelPath == session.path()) {
    const bool current = isSameScene(evaluated->input.level, session.level());
    const bool newShape = evaluated->result.shape != result_.shape;
    if (current || newShape || large()) {
      const bool isLast = requested_ == evaluated->input;
      take(std::move(evaluated->result));
      result_.refined &= current;
      result_.complete &= current && isLast;
      changed = true;
    }
  }
  if (const auto failure = worker_.takeFailure()) {
    if (!(of_.shape == session.level().original.shape))
      forget(session.level());  // what is shown is another's
    result_.problem = *failure;
    result_.complete = true;
    changed = true;
  }
  return changed;
}

// What the worker has not made yet stays as it is, and of what it was.
void LiveUpdater::take(LevelResult evaluated) {
  const LevelResult before = std::exchange(result_, std::move(evaluated));
  noteSculpture();
  makeScene();
  if (result_.problem) {
    of_.match.reset();
  } else if (result_.match) {
    of_.match = matchSubject();
  } else {
    result_.match = before.match;
  }
  const auto keep = [](std::shared_ptr<const Image>& picture, const std::shared_ptr<const Image>& old) {
    if (picture) return false;
    picture = old;
    return true;
  };
  if (!keep(result_.previews.reflection, before.previews.reflection)) of_.reflection = reflectionSubject();
  if (!keep(result_.previews.original, before.previews.original)) of_.original = originalSubject();
  if (!result_.problem) keep(result_.previews.difference, before.previews.difference);
}

// The sculpture is the worker's: live ones start from it.
void LiveUpdater::noteSculpture() {
  of_.shape = result_.level.original.shape;
  of_.emptiness.reset();
  of_.sculpture.reset();
  of_.refined.reset();
  if (!result_.sculpture.sculpture->mesh.triangles.empty()) {
    of_.sculpture = SculptureSubject{result_.source, makeVertexMap(result_.level)};
    of_.refined = makeDeformInput(result_.level, result_.source);
  }
  if (baseSculpture_ == result_.sculpture && baseOriginal_ == result_.original) return;
  baseOriginal_ = result_.original;
  baseSculpture_ = result_.sculpture;
  liveSculpture_.reset();
}

void LiveUpdater::followLevel(const Level& level, const UpdateOptions& options) {
  const Level before = std::exchange(result_.level, level);
  result_.complete = false;
  liveTimes_ = {};
  if (!result_.shape || large()) {
    result_.refined = false;
    makeScene();
    return;
  }
  {
    const Stopwatch watch(liveTimes_.original);
    followOriginal(before);
  }
  {
    const Stopwatch watch(liveTimes_.sculpture);
    followSculpture();
    makeScene();
  }
  const bool compare = !result_.problem && !(of_.match == matchSubject());
  {
    const Stopwatch watch(liveTimes_.preview);
    takeCoarsePictures(options.original, compare);
  }
  const Stopwatch watch(liveTimes_.match);
  followMatch(compare);
}

void LiveUpdater::followOriginal(const LevelScene& before) {
  const OriginalSettings& now = result_.level.original;
  if (!(now.placement == before.original.placement && now.unitize == before.original.unitize)) {
    if (liveShape_ != result_.shape) {
      liveOriginal_.emplace(result_.shape, baseOriginal_);
      liveShape_ = result_.shape;
    }
    result_.original = liveOriginal_->place(now.unitize, now.placement, frameThreads_);
    ++liveCounts_.originals;
  }
  followSource(sculptureInputs(before));
}

// Stays the same mesh as long as it is placed alike, so that a frozen sculpture is seen to be made from the same.
void LiveUpdater::followSource(const SculptureInputs& before) {
  const SculptureInputs now = sculptureInputs(result_.level);
  if (now.unitize == before.unitize && now.placement == before.placement) return;
  result_.source = hasOriginalMoved(result_.level) ? placeOriginal(*result_.shape, now.unitize, now.placement)
                                                   : result_.original.mesh;
}

void LiveUpdater::followSculpture() {
  const Level& level = result_.level;
  result_.warnings.clear();
  result_.problem = findSculptureProblem(level, sourceBox(result_));
  if (result_.problem) {
    of_.sculpture.reset();
    result_.sculpture = emptySculpture({});
    result_.refined = false;
    return;
  }
  SculptureSubject subject{result_.source, makeVertexMap(level)};
  if (!(of_.sculpture == subject)) {
    if (!liveSculpture_) liveSculpture_.emplace(baseOriginal_, baseSculpture_);
    result_.sculpture = liveSculpture_->follow(subject.map, subject.original, frameThreads_);
    ++liveCounts_.sculptures;
    of_.refined.reset();
    of_.emptiness = findEmptiness(*result_.sculpture.sculpture);
    if (of_.emptiness) result_.sculpture = emptySculpture(result_.sculpture.sculpture->originalStatus);
    of_.sculpture = std::move(subject);
  }
  result_.refined = of_.shape == level.original.shape &&  // else another one is being read
                    of_.refined == makeDeformInput(level, result_.source);
  result_.problem = of_.emptiness;
  if (result_.problem) return;
  result_.warnings = findWarnings(level, result_.sculpture);
  result_.problem = findProblem(level, result_.original.box);
}

void LiveUpdater::takeCoarsePictures(bool wantOriginal, bool compare) {
  const Level& level = result_.level;
  const auto [width, height] = pictureSize(level.grid, coarseSize);
  ImageRequest request = makeImageRequest(level, width, height, frameThreads_);
  request.samplesPerAxis = 1;
  if (PictureSubject subject = reflectionSubject(); !(of_.reflection == subject)) {
    result_.previews.reflection = shared(render(*result_.scene, level.camera, request));
    of_.reflection = std::move(subject);
    ++liveCounts_.pictures;
  }
  PictureSubject subject = originalSubject();
  const bool same = of_.original == subject;
  // What is compared has the size of the match.
  const auto& picture = result_.previews.original;
  const bool fits = picture && picture->width == width && picture->height == height;
  if (same && (fits || !(wantOriginal && compare))) return;
  of_.original.reset();
  result_.previews.original = nullptr;
  if (!wantOriginal) return;
  result_.previews.original = shared(render(buildScene(subject.scene), level.camera, request));
  of_.original = std::move(subject);
  ++liveCounts_.pictures;
}

void LiveUpdater::followMatch(bool compare) {
  if (result_.problem) {
    of_.match.reset();
    result_.match = nullptr;
    result_.previews.difference = nullptr;
  }
  if (!compare) return;
  const auto [width, height] = pictureSize(result_.level.grid, coarseSize);
  const auto match = std::make_shared<const Match>(computeMatch(
      makeMatchInput(result_.level, result_.original, result_.sculpture, width, height), frameThreads_));
  ++liveCounts_.matches;
  of_.match = matchSubject();
  result_.match = match;
  result_.previews.difference = nullptr;
  const auto& original = result_.previews.original;
  if (!original || original->width != width || original->height != height) return;
  result_.previews.difference = std::make_shared<const Image>(markDifferences(*original, *match));
}

void LiveUpdater::makeScene() {
  if (!result_.sculpture.sculpture) return;
  result_.scene = scene_.get(
      makeReflectionScene(result_.level, result_.sculpture),
      [](const SceneInput& input) { return std::make_shared<const RenderScene>(buildScene(input)); });
}

void LiveUpdater::request(const Session& session, const UpdateOptions& options) {
  resting_ = false;
  if (cancelled_) return;
  if (session.changing()) {
    const std::chrono::duration<double> still = Clock::now() - lastChange_;
    if (large() ? worker_.busy() : still.count() < restSeconds) {
      resting_ = !large();
      return;
    }
  }
  EvaluationInput wanted{session.level(), session.path(), options.previewSize};
  if (requested_ == wanted) return;
  requested_ = wanted;
  result_.complete = false;
  worker_.request([evaluator = evaluator_, results = results_, wake = wake_, threads = threads_,
                   wanted = std::move(wanted)](const Progress& progress) {
    evaluator->evaluate(
        wanted, threads,
        [&](const LevelResult& part) {
          results->put({wanted, part});
          if (wake) wake();
        },
        progress);
  });
}

bool LiveUpdater::updateRays(const UpdateOptions& options) {
  const Level& level = result_.level;
  const auto before = std::pair{result_.screen, result_.trees};
  if (!result_.scene) return false;  // nothing is there yet
  const Camera& camera = level.camera;
  ImageRequest request = makeImageRequest(level, level.grid.columns, level.grid.rows, frameThreads_);
  if (request.width * request.height > maxSampledCells) request.samplesPerAxis = 1;
  result_.screen = screen_.get({result_.scene, camera, request}, [](const GridKey& key) {
    return shared(render(*key.scene, key.camera, key.request));
  });
  result_.trees = nullptr;
  if (options.trees) {
    result_.trees = trees_.get({result_.scene, camera, request}, [](const GridKey& key) {
      auto trees = std::make_shared<std::vector<RayTree>>();
      for (int y = 0; y < key.request.height; ++y) {
        for (int x = 0; x < key.request.width; ++x) {
          trees->push_back(tracePath(*key.scene, key.camera, key.request, {x + 0.5, y + 0.5}));
        }
      }
      return std::shared_ptr<const std::vector<RayTree>>(trees);
    });
  }
  return before != std::pair{result_.screen, result_.trees};
}

bool LiveUpdater::busy() const {
  return worker_.busy() || resting_;
}

std::optional<double> LiveUpdater::secondsUntilDue() const {
  if (!resting_) return std::nullopt;
  const std::chrono::duration<double> still = Clock::now() - lastChange_;
  return std::max(0.0, restSeconds - still.count());
}

void LiveUpdater::cancel() {
  worker_.cancel();
  cancelled_ = true;
}

void LiveUpdater::restart() {
  if (std::exchange(cancelled_, false)) requested_.reset();
}

void LiveUpdater::finish(const Session& session, const UpdateOptions& options) {
  restart();
  do {
    update(session, options);
    if (result_.complete) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  } while (true);
}

}  // namespace anamorph
