// The match report: how well does what the mirror shows of the sculpture agree with the original seen
// directly? (method section 6). For every pixel of the RT camera's image two rays are asked:
//
//   direct:    eye ---------------------> original     alone: no mirror, no sculpture
//   reflected: eye ----> mirror ----> sculpture        which may itself stand between eye and mirror
//
// A reflected hit lies on a sculpture triangle, so at a known point of the original: where the camera would
// see that point is where it should be. Without a mirror the sculpture is seen directly. Nothing here knows
// how the sculpture was made, so no mistake of the map can hide.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "anamorphosis/sculpture.h"
#include "geometry/bvh.h"

namespace anamorph {

struct MatchInput {
  std::shared_ptr<const Mesh> original;
  std::shared_ptr<const Bvh> originalBvh;
  std::shared_ptr<const Sculpture> sculpture;
  std::shared_ptr<const Bvh> sculptureBvh;
  Optic optic;
  Camera camera;
  int width = 512;  ///< of the image that is compared, in pixels
  int height = 512;

  bool operator==(const MatchInput&) const = default;
};

/// What a pixel shows.
enum class PixelClass : std::uint8_t {
  background,      ///< neither
  both,            ///< original and reflection agree that something is there
  onlyOriginal,    ///< the reflection lacks it
  onlyReflection,  ///< the reflection has it, the original does not
  hidden,          ///< the original is here, but the sculpture itself stands before the mirror
  missed,          ///< the original is here, but there is no mirror
};

struct MatchReport {
  int width = 0;
  int height = 0;
  double silhouetteIou = 0;                 ///< pixels in both / in either; 0 when neither shows anything
  std::size_t comparedPixels = 0;           ///< where both show something; the correspondence is over these
  double meanPx = 0, p99Px = 0, maxPx = 0;  ///< correspondence error; 0 when nothing could be compared
  double triangleAgreement = 0;  ///< share of compared pixels on the same original triangle, or one beside it
  double hiddenShare = 0;        ///< of the original's pixels
  double missedShare = 0;        ///< of the original's pixels
};

/// Where in the image pixel (x, y) is asked: at a place of its own within it, hashed from its coordinates, so
/// that an edge along a row of pixels does not decide over the whole row at once.
Pixel matchSample(int x, int y);

struct Match {
  MatchReport report;
  std::vector<PixelClass> classes;  ///< width * height, row by row from the top
};

enum class MatchGrade { excellent, match, partial, none };

/// In words. Excellent: every figure is good as in method section 6, nothing hidden, nothing missed. Match:
/// IoU >= 0.99, p99 <= 1 px, agreement >= 0.99. Partial: the silhouettes overlap by half. Else none.
MatchGrade gradeOf(const MatchReport& report);
const char* matchGradeName(MatchGrade grade);

/// Deterministic for any thread count. A cancelled run returns an empty report.
Match computeMatch(const MatchInput& input, int threads = 1, const Progress& progress = {});

}  // namespace anamorph
