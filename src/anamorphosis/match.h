// The match report: how well does what the mirror shows of the sculpture agree with the original seen
// directly? (method section 6). For every pixel of the RT camera's image two rays are asked:
//
//   direct:    eye ---------------------> original     alone: no mirror, no sculpture
//   reflected: eye ----> mirror ----> sculpture        which may itself stand between eye and mirror
//
// A reflected hit lies on a sculpture triangle, so at a known point of the original: where the camera would
// see that point is where it should be. Without a mirror the sculpture is seen directly. What else stands in the
// scene, a floor or a base plate, hides the sculpture as it does in the picture; the original is asked alone. Nothing
// here knows how the sculpture was made, so no mistake of the map can hide.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "anamorphosis/match_classes.h"
#include "anamorphosis/sculpture.h"
#include "geometry/bvh.h"
#include "optics/floor.h"

namespace anamorph {

struct MatchInput {
  std::shared_ptr<const Mesh> original;
  std::shared_ptr<const Bvh> originalBvh;
  std::shared_ptr<const Sculpture> sculpture;
  std::shared_ptr<const Bvh> sculptureBvh;
  Optic optic;
  Camera camera;
  std::optional<Floor> floor;
  /// Whether the original stands elsewhere than the sculpture was made from: its points are found anew, by their sources.
  bool originalMoved = false;
  std::shared_ptr<const Bvh> obstacle;  ///< something solid beside the sculpture, a base plate; null: nothing
  int width = 512;                      ///< of the image that is compared, in pixels
  int height = 512;

  bool operator==(const MatchInput&) const = default;
};

struct MatchReport {
  int width = 0;
  int height = 0;
  double silhouetteIou = 0;                 ///< pixels in both / in either; 0 when neither shows anything
  std::size_t comparedPixels = 0;           ///< where both show something; the correspondence is over these
  double meanPx = 0, p99Px = 0, maxPx = 0;  ///< correspondence error; 0 when nothing could be compared
  /// Share of compared pixels that show the triangle of the original that is seen there, one beside it, or a point that
  /// the eye does see where the error puts it: not one that something before it should hide.
  double triangleAgreement = 0;
  std::size_t originalPixels = 0;  ///< that the original covers
  double hiddenShare = 0;          ///< of the original's pixels
  double missedShare = 0;          ///< of the original's pixels
  double foldedShare = 0;          ///< of what the eye sees of the original's mapped triangles (folds.h)
  double extraShare =
      0;  ///< pixels that show the sculpture more than 1 px beside the original, over its pixels
  /// Between the outlines of original and reflection (contour.h), to a quarter of a pixel; where something is hidden
  /// or missed the reflection's outline is not asked.
  double contourPx = 0;
};

/// Where in the image pixel (x, y) is asked: at a place of its own within it, hashed from its coordinates, so
/// that an edge along a row of pixels does not decide over the whole row at once.
Pixel matchSample(int x, int y);

struct Match {
  MatchReport report;
  std::vector<PixelClass> classes;  ///< width * height, row by row from the top
};

enum class MatchGrade { excellent, match, partial, poor, none, tooSmall };

constexpr int matchGradeCount = 6;

/// In words: the best grade whose bounds all figures keep. None: nothing of the sculpture is seen where the original
/// is. Too small: the original covers so few pixels that no figure says anything.
MatchGrade gradeOf(const MatchReport& report);
const char* matchGradeName(MatchGrade grade);

/// What a figure may be for a grade; the table of all is in match.cpp.
struct MatchBounds {
  MatchGrade grade;
  double contourPx, p99Px, triangleAgreement;  ///< agreement: at least
  double hiddenShare, missedShare, extraShare;
};
const MatchBounds& boundsOf(MatchGrade grade);  ///< of excellent, match or partial (CHECK)

/// Deterministic for any thread count. A cancelled run returns an empty report.
Match computeMatch(const MatchInput& input, int threads = 1, const Progress& progress = {});

}  // namespace anamorph
