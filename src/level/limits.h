// What numbers may be, one table for all who ask: the fields of a level, the moves of a lesson, edits by the mouse, the
// rows of the panels and the options of the command line.
//
//   a Range   is the same everywhere
//   a Limit   where panels offer less than a level may hold, both side by side: a slider is useful only where most of
//             its way makes sense
#pragma once

#include <cstddef>

namespace anamorph {

/// Both ends included.
struct Range {
  double min, max;

  constexpr bool holds(double number) const { return number >= min && number <= max; }
  constexpr bool holds(const Range& other) const { return other.min >= min && other.max <= max; }
};

struct Limit {
  /// As a constant it does not compile where panels would offer what is not allowed.
  constexpr Limit(Range allowed, Range offered) : level(allowed), panel(offered) {
    if (!level.holds(panel)) throw "panels offer what is not allowed";
  }

  Range level;  ///< in files, and on the command line
  Range panel;  ///< in the panels
};

namespace limits {

// ---- Everywhere: scene units, degrees of rotations, shares

constexpr Range coordinates{-1e6, 1e6};
constexpr Range lengths{1e-6, 1e6};
constexpr Range lengthsOrZero{0, lengths.max};  ///< of what may vanish
constexpr Range degrees{-1e6, 1e6};             ///< of rotations
constexpr Range fractions{0, 1};
constexpr Range lookingDown{0, 90};     // degrees
constexpr Range formatVersion{1, 1e6};  ///< of a level's file

// ---- RT camera and 3D view

constexpr Limit fieldOfView{{1, 170}, {20, 120}};
constexpr Limit viewFieldOfView{{1, 170}, {10, 120}};
constexpr Range poseFieldOfView{0.1, 175};  ///< that a pose is kept within, whatever was asked for
constexpr Range gridCells{1, 64};           ///< each way
constexpr Limit gridDistance{lengths, {0.1, 2}};

// ---- The optic

/// Control values of a curve; a closed one needs three, an open one four.
constexpr Range splinePoints{3, 200};
constexpr Range patchPoints{4, 64};   ///< each way
constexpr std::size_t mostClips = 8;  ///< planes that cut a mirror off

// ---- Originals

constexpr Limit shapeSize{lengths, {0.01, 1000}};
constexpr Limit shapeScale{lengths, {1e-6, 1000}};
constexpr Limit boxSegments{{1, 512}, {1, 64}};
constexpr Limit sphereSegments{{3, 2048}, {3, 256}};
constexpr Limit knotSegments{{3, 4096}, {3, 1024}};
constexpr Limit knotSides{{3, 512}, {3, 64}};
constexpr Range knotTurns{1, 32};  ///< p and q
constexpr Range tubeRadius{0.01, 1};
constexpr Limit letterSegments{{1, 256}, {1, 64}};
constexpr Limit pawnSegments{{3, 2048}, {3, 256}};
constexpr std::size_t mostInsideBytes = 200'000;  ///< of a mesh that is inside a level

// ---- The sculpture

constexpr Limit depthScale{{0.01, 100}, {0.01, 4}};
constexpr Limit depthOffset{{0, 1e6}, {0, 100}};       ///< scene units
constexpr Limit tolerance{{0.001, 1000}, {0.05, 10}};  ///< pixels
constexpr Range imageSize{16, 16384};                  ///< that the tolerance is meant for
constexpr Range triangles{1, 1e8};

// ---- Light, materials, tracing

constexpr std::size_t mostLights = 64, mostOfferedLights = 8;
constexpr Limit lightIntensity{{0, 1000}, {0, 3}};
constexpr Limit shininess{{1, 1000}, {1, 128}};
constexpr Range reflections{0, 8};     ///< that are followed in a row
constexpr Range samplesPerAxis{1, 4};  ///< of a pixel

// ---- Texts, in bytes: what is read aloud in an hour is not longer

constexpr std::size_t mostTextBytes = std::size_t{64} << 10;  ///< of a title, a description, a text of a step
constexpr std::size_t mostLessonBytes = std::size_t{1} << 20;
constexpr std::size_t mostPathBytes = 4096;   ///< as the system
constexpr std::size_t mostTitleBytes = 1000;  ///< that can be typed

// ---- Lessons

constexpr std::size_t mostSteps = 100, mostConditions = 8, mostAnswers = 5;
constexpr Range vertexNumber{0, 1e8};
constexpr Range controlPointNumber{0, patchPoints.max* patchPoints.max - 1};
constexpr Range cellNumber{gridCells.min - 1, gridCells.max - 1};

// ---- Rays and the morph, which only the view shows

constexpr Range drawnVertexRays{1, 400};
constexpr Range rayThickness{0.5, 8};  ///< pixels at 100 %
constexpr Range rayExponent{0, 2};
constexpr Range raySpeed{0, 10};  ///< scene units a second

// ---- Files and pictures; `level` is what the command line takes

constexpr Limit millimetresPerUnit{{1e-6, 1e6}, {0.001, 1000}};
constexpr Limit smallestWidth{{0.001, 100}, {0.05, 10}};  ///< millimetres, of a printed wall
constexpr Limit plateThickness{{0.2, 100}, {0.2, 50}};    ///< millimetres, like the margin
constexpr Limit plateMargin{{0, 1000}, {0, 100}};
constexpr Range scaleOnPaper{1e-3, 1e3}, scaleInLife{1e-3, 1e6};  ///< one : the other
constexpr Limit sheetScale{{scaleInLife.min / scaleOnPaper.max, scaleInLife.max / scaleOnPaper.min},
                           {0.1, 1000}};  ///< 1 : this
constexpr Limit exportedVertexRays{{1, 1'000'000}, {1, 10'000}};
constexpr Limit exportedSize{{16, 8192}, {16, 8192}};  ///< pixels of a picture's longer side
constexpr Limit comparedSize{exportedSize.level, {16, 4096}};
constexpr Limit renderedSize{{1, 8192}, {64, 8192}};
constexpr Range pictureSide{1, 16384};  ///< of a size that is given as WIDTHxHEIGHT
constexpr Range megapixels{1e-6, 300};

// ---- The program itself

constexpr Range threads{1, 1024};
constexpr Range meshMebibytes{1, 1 << 20};
constexpr Range meshVertices{1, 4e9};
constexpr Range benchFrames{10, 100000};

// ---- The window

constexpr Range uiScale{0.75, 3};
constexpr Range shotFactor{1, 4};  ///< times as large as the window

}  // namespace limits
}  // namespace anamorph
