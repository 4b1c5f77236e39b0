#include "edit/level_trial.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/evaluator.h"

namespace anamorph {

static_assert(fullTrial == matchSize);

bool isNoWorse(const Trial& after, const Trial& before) {
  if (!before.sound) return true;
  const double pixels = static_cast<double>(std::min(after.originalPixels, before.originalPixels));
  return after.sound && after.grade <= before.grade &&
         after.silhouetteIou >= before.silhouetteIou - 0.5 / std::sqrt(pixels);
}

Trial Trials::at(const Level& level, std::shared_ptr<const Mesh> placed, int longerSide) {
  if (level.sculpture.frozen) return {};
  ++count_;
  progress_.update(std::min(0.98, double(count_) / most_));
  const Progress silent{{}, progress_.token};
  Level tried = level;
  if (longerSide < fullTrial) {
    tried.sculpture.imageSize = longerSide;
    tried.sculpture.maxTriangles = std::min<std::size_t>(tried.sculpture.maxTriangles, 100'000);
  }
  const auto finished = finishLevel(tried, std::move(placed), threads_, silent);
  if (!finished || finished->problem) return {};
  const auto [width, height] = pictureSize(level.grid, longerSide);
  const MatchReport report = matchLevel(*finished, width, height, threads_, silent).report;
  if (cancelled()) return {};
  Trial trial;
  trial.grade = gradeOf(report);
  trial.sound = report.comparedPixels > 0 && trial.grade != MatchGrade::tooSmall;
  if (!trial.sound) return {};
  const StatusCounts& counts = finished->sculpture.sculpture->originalStatus;
  trial.mapped = std::all_of(counts.begin() + 1, counts.end(), [](std::size_t count) { return count == 0; });
  trial.hiddenShare = report.hiddenShare;
  trial.missedShare = report.missedShare;
  trial.shownShare = double(report.comparedPixels) / double(report.originalPixels);
  trial.silhouetteIou = report.silhouetteIou;
  trial.originalPixels = report.originalPixels;
  return trial;
}

}  // namespace anamorph
