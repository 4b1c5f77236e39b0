// How good a level would be: what a search for a better one asks of its candidates (level_helpers.h). Small images find
// where to look; what counts is the image that the window and the command line judge by.
#pragma once

#include <cstddef>
#include <memory>

#include "anamorphosis/match.h"
#include "base/progress.h"
#include "geometry/mesh.h"
#include "level/level.h"

namespace anamorph {

struct Trial {
  bool sound = false;   ///< it can be computed, and there is something to judge
  bool mapped = false;  ///< every vertex of the original is
  double hiddenShare = 0, missedShare = 0;
  double shownShare = 0;  ///< of the original's pixels: those that show the sculpture too
  double silhouetteIou = 0;
  std::size_t originalPixels = 0;
  MatchGrade grade = MatchGrade::none;

  bool clear() const { return sound && mapped && hiddenShare == 0 && missedShare == 0; }
};

/// Whether the match is at least as good: its grade, and its silhouette but for what a border of pixels cannot tell, which
/// is more of a small original. Always when there was none before.
bool isNoWorse(const Trial& after, const Trial& before);

/// Longer sides of the images: to find where to look, to look closer, and as everybody judges.
constexpr int coarseTrial = 96, fineTrial = 256, fullTrial = 512;

/// Tries levels, and counts them as progress towards `most` (it stays below 1 beyond that).
class Trials {
 public:
  Trials(int threads, const Progress& progress, int most)
      : threads_(threads), progress_(progress), most_(most) {}

  /// `placed`: the original in scene coordinates. With fewer pixels than fullTrial the sculpture is made as coarse as
  /// those ask for. Not sound when cancelled, and for a frozen sculpture, which follows nothing.
  Trial at(const Level& level, std::shared_ptr<const Mesh> placed, int longerSide);

  bool cancelled() const { return progress_.cancelled(); }

 private:
  int threads_;
  const Progress& progress_;
  int most_, count_ = 0;
};

}  // namespace anamorph
