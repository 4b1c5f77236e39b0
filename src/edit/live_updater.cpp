#include "edit/live_updater.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "base/parallel_for.h"
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

// One that has an area, as findEmptiness wants it.
bool anyTriangleMapped(const Sculpture& sculpture) {
  const auto& status = sculpture.status;
  const auto mapped = [&](std::uint32_t corner) { return status[corner] == PathStatus::mapped; };
  return std::any_of(
      sculpture.mesh.triangles.begin(), sculpture.mesh.triangles.end(), [&](const Triangle& t) {
        return mapped(t[0]) && mapped(t[1]) && mapped(t[2]) && areaVector(sculpture.original, t) != Vector(0);
      });
}

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
  return products_.shape && products_.shape->positions.size() > liveVertexLimit;
}

bool LiveUpdater::update(const Session& session, const UpdateOptions& options) {
  bool changed = false;
  if (session.generation() != generation_) {
    openLevel(session);
    changed = true;
  }
  changed |= takeResults(session);
  const bool moved = !(products_.level == session.level());
  if (moved) {
    lastChange_ = Clock::now();
    cancelled_ = false;
    if (session.changing() && !large()) {
      worker_.cancel();
      requested_.reset();
    }
    followLevel(session.level(), options);
    changed = true;
  }
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
  results_ = std::make_shared<Mailbox<Settled>>();
  requested_.reset();
  cancelled_ = false;
  products_ = {};
  products_.level = session.level();
  liveOriginal_.reset();
  liveShape_.reset();
  liveSculpture_.reset();
  baseOriginal_ = {};
  baseSculpture_ = {};
}

bool LiveUpdater::takeResults(const Session& session) {
  bool changed = false;
  if (const auto settled = results_->take(); settled && settled->input.levelPath == session.path()) {
    const bool current = settled->input.level == session.level();
    const bool newShape = settled->shape != products_.shape;
    if (current || newShape || large()) {
      adopt(*settled, current);
      changed = true;
    }
  }
  if (const auto failure = worker_.takeFailure()) {
    products_.problem = *failure;
    products_.complete = true;
    changed = true;
  }
  return changed;
}

// What is not current is a new start for the live step, which follows at once.
void LiveUpdater::adopt(const Settled& settled, bool current) {
  products_.level = settled.input.level;
  products_.shape = settled.shape;
  products_.original = settled.original;
  products_.sculpture = settled.sculpture;
  products_.problem = settled.problem;
  products_.warnings = settled.warnings;
  products_.refined = current;
  products_.complete = current && settled.complete && requested_ == settled.input;
  if (settled.match || settled.problem) products_.match = settled.match;
  if (settled.previews.reflection) products_.previews.reflection = settled.previews.reflection;
  if (settled.previews.original) products_.previews.original = settled.previews.original;
  if (settled.previews.difference || settled.problem)
    products_.previews.difference = settled.previews.difference;
  if (baseSculpture_ == settled.sculpture && baseOriginal_ == settled.original) return;
  baseOriginal_ = settled.original;
  baseSculpture_ = settled.sculpture;
  liveSculpture_.reset();
}

void LiveUpdater::followLevel(const Level& level, const UpdateOptions& options) {
  const Level before = std::exchange(products_.level, level);
  products_.refined = products_.complete = false;
  liveTimes_ = {};
  if (!products_.shape || large()) return;
  {
    const Stopwatch watch(liveTimes_.original);
    if (liveShape_ != products_.shape) {
      liveOriginal_.emplace(products_.shape, baseOriginal_);
      liveShape_ = products_.shape;
    }
    const OriginalSettings& now = level.original;
    if (!(now.placement == before.original.placement) || now.unitize != before.original.unitize) {
      products_.original = liveOriginal_->place(now.unitize, now.placement, frameThreads_);
    }
  }
  {
    const Stopwatch watch(liveTimes_.sculpture);
    followSculpture(level);
  }
  takeCoarsePictures(level, options.original);
}

void LiveUpdater::followSculpture(const Level& level) {
  products_.warnings.clear();
  products_.problem = findProblem(level, *products_.original.mesh);
  if (products_.problem) {
    products_.sculpture = prepareSculpture({});
    return;
  }
  if (!liveSculpture_) liveSculpture_.emplace(baseOriginal_, baseSculpture_);
  products_.sculpture = liveSculpture_->follow(level, products_.original.mesh, frameThreads_);
  const Sculpture& sculpture = *products_.sculpture.sculpture;
  if (!anyTriangleMapped(sculpture)) {
    Sculpture empty;
    empty.originalStatus = sculpture.originalStatus;
    products_.problem = findEmptiness(empty);
    products_.sculpture = prepareSculpture(std::move(empty));
    return;
  }
  products_.warnings = findWarnings(level, sculpture);
}

void LiveUpdater::takeCoarsePictures(const Level& level, bool original) {
  const auto [width, height] = pictureSize(level.camera, coarseSize);
  ImageRequest request = makeImageRequest(level, width, height, frameThreads_);
  request.samplesPerAxis = 1;
  {
    const Stopwatch watch(liveTimes_.preview);
    products_.previews.reflection = shared(render(*sceneOf(level), level.camera, request));
    products_.previews.original = nullptr;
    if (original) {
      const RenderScene alone = buildScene(makeOriginalScene(level, products_.original));
      products_.previews.original = shared(render(alone, level.camera, request));
    }
  }
  const Stopwatch watch(liveTimes_.match);
  products_.match = nullptr;
  products_.previews.difference = nullptr;
  if (products_.problem) return;
  const auto match = std::make_shared<const Match>(computeMatch(
      makeMatchInput(level, products_.original, products_.sculpture, width, height), frameThreads_));
  if (original) {
    products_.previews.difference =
        std::make_shared<const Image>(markDifferences(*products_.previews.original, *match));
  }
  products_.match = match;
}

std::shared_ptr<const RenderScene> LiveUpdater::sceneOf(const Level& level) {
  return scene_.get(makeReflectionScene(level, products_.sculpture), [](const SceneInput& input) {
    return std::make_shared<const RenderScene>(buildScene(input));
  });
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
  products_.complete = false;
  worker_.request([evaluator = evaluator_, results = results_, wake = wake_, threads = threads_,
                   wanted = std::move(wanted)](const Progress& progress) {
    evaluator->evaluate(
        wanted, threads,
        [&](const Settled& part) {
          results->put(part);
          if (wake) wake();
        },
        progress);
  });
}

bool LiveUpdater::updateRays(const UpdateOptions& options) {
  const Level& level = products_.level;
  if (!products_.sculpture.sculpture) {
    const bool had = products_.scene != nullptr;
    products_.scene = nullptr;
    products_.screen = nullptr;
    products_.trees = nullptr;
    return had;
  }
  const auto before = std::pair{products_.screen, products_.trees};
  products_.scene = sceneOf(level);
  const Camera& camera = level.camera;
  ImageRequest request = makeImageRequest(level, camera.gridColumns, camera.gridRows, frameThreads_);
  if (request.width * request.height > maxSampledCells) request.samplesPerAxis = 1;
  products_.screen = screen_.get({products_.scene, camera, request}, [](const GridKey& key) {
    return shared(render(*key.scene, key.camera, key.request));
  });
  products_.trees = nullptr;
  if (options.trees) {
    products_.trees = trees_.get({products_.scene, camera, request}, [](const GridKey& key) {
      auto trees = std::make_shared<std::vector<RayTree>>();
      for (int y = 0; y < key.request.height; ++y) {
        for (int x = 0; x < key.request.width; ++x) {
          trees->push_back(tracePath(*key.scene, key.camera, key.request, {x + 0.5, y + 0.5}));
        }
      }
      return std::shared_ptr<const std::vector<RayTree>>(trees);
    });
  }
  return before != std::pair{products_.screen, products_.trees};
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
    if (products_.complete) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  } while (true);
}

}  // namespace anamorph
