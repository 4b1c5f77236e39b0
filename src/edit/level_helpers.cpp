#include "edit/level_helpers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "anamorphosis/map_points.h"
#include "edit/level_edits.h"
#include "edit/level_repairs.h"
#include "edit/level_trial.h"
#include "pipeline/stages.h"

namespace anamorph {
namespace {

constexpr double margin = 0.98;
constexpr double highest = 85;       // degrees: straight from above there is no up any more
constexpr double heightStep = 2;     // degrees
constexpr double fineDegrees = 0.1;  // how well the height is found
constexpr int mostConfirmed = 8;     // places that are looked at closer

// Whether every vertex is mapped when the original is scaled about `centre`.
class Fits {
 public:
  Fits(const LevelScene& level, const PointArray& placed, const Point& centre)
      : map_(makeVertexMap(level)), placed_(placed), centre_(centre) {
    map_.mistakes = {};
  }

  bool operator()(double factor) {
    scaled_ = mapPoints(placed_, [&](const Point& p) { return centre_ + factor * (p - centre_); });
    mapPointsThrough(map_, scaled_, mapped_);
    return std::all_of(mapped_.status.begin(), mapped_.status.end(),
                       [](PathStatus status) { return status == PathStatus::mapped; });
  }

 private:
  VertexMap map_;
  const PointArray& placed_;
  Point centre_;
  PointArray scaled_;
  MappedPoints mapped_;
};

// The largest factor with which every vertex is mapped, less the margin; nothing where none is, or where it has no end.
std::optional<double> largestMapped(const Level& level, const PointArray& placed, const Point& centre) {
  Fits fits(level, placed, centre);
  constexpr double step = 1.5, smallest = 1e-4, largest = 1e4;
  double good = 1, bad = 1;
  if (fits(1)) {
    while (fits(bad *= step)) {
      good = bad;
      if (good > largest) return std::nullopt;  // a mirror without end
    }
  } else {
    do {
      good = bad / step;
      if (good < smallest) return std::nullopt;
      if (fits(good)) break;
      bad = good;
    } while (true);
  }
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (good + bad);
    (fits(middle) ? good : bad) = middle;
  }
  return fits(margin * good) ? std::optional(margin * good) : std::nullopt;
}

std::pair<Level, std::shared_ptr<const Mesh>> scaledOriginal(const Level& level, const Mesh& placed,
                                                             const Point& centre, double factor) {
  Mesh mesh = placed;
  mesh.positions =
      mapPoints(placed.positions, [&](const Point& p) { return centre + factor * (p - centre); });
  return {scaled(level, {Part::original}, centre, Vector(factor)),
          std::make_shared<const Mesh>(std::move(mesh))};
}

// The largest factor up to `largest` that is clear in all sizes of image: downwards in steps, then between the last
// two. Hiding does not grow with the size in any regular way, so no factor is skipped that a step would meet.
std::optional<double> largestClear(double largest, const std::function<bool(double, int)>& isClear,
                                   const CancelToken& token) {
  constexpr double step = 0.85;
  constexpr int steps = 24;
  double bad = largest;
  for (int i = 0; i < steps && !token.cancelled(); ++i, bad *= step) {
    double good = i == 0 ? largest : bad * step;
    if (!isClear(good, coarseTrial)) continue;
    for (int k = 0; k < 4 && i > 0 && !token.cancelled(); ++k) {
      const double middle = 0.5 * (good + bad);
      (isClear(middle, coarseTrial) ? good : bad) = middle;
    }
    for (const double factor : {good, margin * good}) {
      if (isClear(factor, fineTrial) && isClear(factor, fullTrial)) return factor;
    }
    bad = good;
  }
  return std::nullopt;
}

// Around `pivot`, as high as `degrees` above the horizon; the side stays.
Point eyeAt(const Point& eye, const Point& pivot, double degrees) {
  const Vector arm = eye - pivot;
  const double flat = std::hypot(arm.x, arm.y), angle = radians(degrees);
  const Vector side = flat > 0 ? Vector(arm.x / flat, arm.y / flat, 0) : Vector(0, -1, 0);
  return pivot + glm::length(arm) * (std::cos(angle) * side + std::sin(angle) * Vector(0, 0, 1));
}

double heightOf(const Point& eye, const Point& pivot) {
  const Vector arm = eye - pivot;
  return std::atan2(arm.z, std::hypot(arm.x, arm.y)) * 180 / pi;
}

// The search for the height of an eye.
class Lift {
 public:
  Lift(const Level& level, std::shared_ptr<const Mesh> placed, Trials& trials)
      : level_(level),
        placed_(std::move(placed)),
        pivot_(boundingBox(placed_->positions).centre()),
        start_(heightOf(level.camera.eye, pivot_)),
        trials_(trials),
        before_(at(start_, fullTrial)) {}

  bool nothingHidden() const { return before_.sound && before_.hiddenShare == 0; }

  // From below in steps. The first height where nothing is hidden is kept for the case that none is clear.
  std::optional<Level> search() {
    std::optional<Level> unhidden;
    double bad = start_;
    int confirmed = 0;
    for (double good = start_ + heightStep;
         good <= highest && confirmed < mostConfirmed && !trials_.cancelled();
         bad = good, good += heightStep) {
      const Trial found = at(good, coarseTrial);
      if (!isUnhidden(found) || (unhidden && !found.clear())) continue;
      ++confirmed;
      const auto lowest = lowestBetween(bad, good, found.clear());
      if (lowest && found.clear()) return lowest;
      if (lowest && !unhidden) unhidden = lowest;
    }
    return unhidden;
  }

 private:
  Level lifted(double degrees) const {
    Level result = level_;
    if (degrees != start_) result.camera.eye = clampedPoint(eyeAt(level_.camera.eye, pivot_, degrees));
    return result;
  }
  Trial at(double degrees, int size) { return trials_.at(lifted(degrees), placed_, size); }

  // As a small image tells; a pixel of it is allowed for.
  bool isUnhidden(const Trial& trial) const {
    return trial.sound && trial.hiddenShare == 0 && trial.missedShare <= before_.missedShare + 0.005;
  }

  bool isAnswer(double degrees, bool clear) {
    const Trial closer = at(degrees, fineTrial);
    if (!isUnhidden(closer) || (clear && !closer.clear())) return false;
    const Trial full = at(degrees, fullTrial);
    return full.sound && full.hiddenShare == 0 && isNoWorse(full, before_) &&
           (full.clear() || (!clear && full.missedShare <= before_.missedShare));
  }

  // Small images tell where, larger ones decide; what only those see needs a little more.
  std::optional<Level> lowestBetween(double bad, double good, bool clear) {
    const double end = good;
    while (good - bad > fineDegrees && !trials_.cancelled()) {
      const double middle = 0.5 * (good + bad);
      const Trial trial = at(middle, coarseTrial);
      ((clear ? trial.clear() : isUnhidden(trial)) ? good : bad) = middle;
    }
    for (const double degrees : {good, good + 0.2, good + 0.6, end, end + 0.6}) {
      if (degrees <= highest && !trials_.cancelled() && isAnswer(degrees, clear)) return lifted(degrees);
    }
    return std::nullopt;
  }

  const Level& level_;
  std::shared_ptr<const Mesh> placed_;
  Point pivot_;
  double start_;
  Trials& trials_;
  Trial before_;
};

bool canBeSearched(const Level& level, const std::shared_ptr<const Mesh>& placed) {
  return placed && !placed->positions.empty() && !level.sculpture.frozen && !findProblem(level.optic) &&
         !findEyeProblem(level.optic, level.camera.eye) && isFinite(boundingBox(placed->positions).centre());
}

}  // namespace

std::optional<Level> originalFittedToMirror(const Level& level, std::shared_ptr<const Mesh> placed,
                                            int threads, const Progress& progress) {
  if (!canBeSearched(level, placed)) return std::nullopt;
  const Box box = boundingBox(placed->positions);
  if (!(box.diagonal() > 0)) return std::nullopt;
  const auto largest = largestMapped(level, placed->positions, box.centre());
  if (!largest) return std::nullopt;
  Trials trials(threads, progress, 40);
  const Trial before = trials.at(level, placed, fullTrial);
  const auto isClear = [&](double factor, int size) {
    const auto [scaledLevel, mesh] = scaledOriginal(level, *placed, box.centre(), factor);
    const Trial trial = trials.at(scaledLevel, mesh, size);
    return trial.clear() && (size < fullTrial || isNoWorse(trial, before));
  };
  const auto factor = largestClear(*largest, isClear, progress.token);
  if (progress.cancelled()) return std::nullopt;
  // What is as good as it can be is not made smaller.
  if ((!factor || *factor <= 1) && before.clear()) return level;
  if (!factor) return std::nullopt;
  return scaledOriginal(level, *placed, box.centre(), *factor).first;
}

std::optional<Level> eyeLifted(const Level& level, std::shared_ptr<const Mesh> placed, int threads,
                               const Progress& progress) {
  if (!canBeSearched(level, placed)) return std::nullopt;
  Trials trials(threads, progress, 60);
  Lift lift(level, std::move(placed), trials);
  if (lift.nothingHidden()) return level;
  auto found = lift.search();
  return progress.cancelled() ? std::nullopt : found;
}

std::optional<Level> originalPutBehind(const Level& level, std::shared_ptr<const Mesh> placed, int threads,
                                       const Progress& progress) {
  if (!canBeSearched(level, placed)) return std::nullopt;
  constexpr int steps = 24;
  constexpr double farthest = 8;
  const Box box = boundingBox(placed->positions);
  Trials trials(threads, progress, steps + 4);
  const Trial before = trials.at(level, placed, fullTrial);
  const Level nearest = originalMovedBehind(level, box);
  if (nearest == level && before.clear()) return level;
  const Vector first = nearest.original.placement.position - level.original.placement.position;
  const Vector sight = box.centre() + first - level.camera.eye;
  const auto at = [&](int i) {
    const Vector way = (std::pow(farthest, double(i) / steps) - 1) * sight;
    return i == 0 ? nearest : moved(nearest, {Part::original}, way);
  };
  const auto tried = [&](const Level& candidate, int size) {
    const Vector way = candidate.original.placement.position - level.original.placement.position;
    auto mesh = std::make_shared<Mesh>(*placed);
    mesh->positions = mapPoints(placed->positions, [&](const Point& p) { return p + way; });
    return trials.at(candidate, mesh, size);
  };
  std::optional<Level> best;
  double mostShown = 0;
  int confirmed = 0;
  for (int i = 0; i <= steps && !progress.cancelled(); ++i) {
    const Level candidate = at(i);
    const Trial trial = tried(candidate, coarseTrial);
    if (trial.clear() && ++confirmed <= mostConfirmed) {
      const Trial full = tried(candidate, fullTrial);
      if (full.clear() && isNoWorse(full, before)) return candidate;
    }
    if (trial.sound && trial.shownShare > mostShown) {
      mostShown = trial.shownShare;
      best = candidate;
    }
  }
  if (!best || progress.cancelled()) return std::nullopt;
  const Trial full = tried(*best, fullTrial);
  const bool better = full.sound && isNoWorse(full, before) && full.shownShare > before.shownShare;
  return better && !(*best == level) ? best : std::nullopt;
}

}  // namespace anamorph
