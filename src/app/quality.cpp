#include "app/quality.h"

#include <algorithm>
#include <cmath>

namespace anamorph {
namespace {

constexpr double frameBudget = 7;  // ms of a graphics processor for one frame: 120 frames a second
constexpr double slowBudget = 40;  // ms of a slow one for a whole picture while something moves
constexpr double slowPiece = 50;   // ms of a slow one for what a frame draws of a picture
constexpr double smallestScale = 0.125, firstScale = 0.25;  // the second while nothing is known
constexpr double stillSeconds = 0.12;                       // before the fine picture begins
constexpr int hardwareSamples = 32, softwareSamples = 8;

}  // namespace

bool QualityGovernor::slow() const {
  return software_ || millisecondsPerSample_ > slowPiece;
}

ViewQuality QualityGovernor::next(bool moving, double secondsStill) {
  if (!slow()) {
    const double cost = std::max(millisecondsPerSample_, 0.1);
    const int affordable = std::clamp(static_cast<int>(frameBudget / cost), 1, 4);
    return {1, affordable, moving ? affordable : hardwareSamples};
  }
  if (!moving && secondsStill >= stillSeconds)
    return {1, 1, software_ ? softwareSamples : hardwareSamples, slowPiece};
  // Cost goes with the area. In steps, so that the picture does not change its size in every frame.
  const double wanted =
      millisecondsPerSample_ > 0 ? std::sqrt(slowBudget / millisecondsPerSample_) : firstScale;
  return {std::clamp(std::floor(8 * wanted) / 8, smallestScale, 1.0), 1, 1, slowPiece};
}

bool QualityGovernor::isFinal(const ViewQuality& quality) const {
  return quality.scale == 1 && quality.samples >= (software_ ? softwareSamples : hardwareSamples);
}

void QualityGovernor::took(const ViewQuality& quality, double milliseconds) {
  const double cost = milliseconds / (quality.scale * quality.scale * std::max(1, quality.samplesNow));
  millisecondsPerSample_ = millisecondsPerSample_ > 0 ? 0.7 * millisecondsPerSample_ + 0.3 * cost : cost;
}

}  // namespace anamorph
