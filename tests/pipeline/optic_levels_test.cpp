// Every mirror, whole: checked geometries (tests/data/optics) come out as excellent as the mathematics says, and what is
// wrong with a sculpture is seen in the match.

#include <array>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "level/level_json.h"
#include "optics/extrusion.h"
#include "optics/patch.h"
#include "optics/revolution.h"
#include "optics/sphere.h"
#include "pipeline/evaluator.h"
#include "pipeline/original.h"

namespace anamorph {
namespace {

Level levelNamed(const std::string& name) {
  return loadLevel(std::string(ANAMORPH_TEST_DATA) + "/optics/" + name + ".json").level;
}

LevelResult resultOf(const Level& level) {
  const auto shape = loadOriginal(level.original.shape, "").mesh;
  return *finishLevel(level, placeOriginal(*shape, level), 2);
}

MatchReport reportOf(const Level& seen, const LevelResult& made, int size = 512) {
  return computeMatch(makeMatchInput(seen, made.original, made.sculpture, size, size), 2).report;
}

class OpticLevels : public testing::TestWithParam<const char*> {};

TEST_P(OpticLevels, AreExcellent) {
  const Level level = levelNamed(GetParam());
  const LevelResult result = resultOf(level);
  ASSERT_EQ(result.problem, std::nullopt);
  const Sculpture& sculpture = *result.sculpture.sculpture;
  EXPECT_EQ(sculpture.originalStatus[0], result.original.mesh->positions.size()) << "all vertices are mapped";
  EXPECT_EQ(sculpture.folded.triangles, 0u);
  EXPECT_GT(signedVolume(sculpture.mesh), 0) << "outside stays outside (fact G9)";
  const MatchReport report = reportOf(level, result);
  EXPECT_GE(report.silhouetteIou, 0.999);
  EXPECT_LE(report.p99Px, 0.3);
  EXPECT_EQ(report.hiddenShare, 0);
  EXPECT_EQ(report.missedShare, 0);
  EXPECT_EQ(report.foldedShare, 0);
  EXPECT_LE(report.extraShare, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Checked, OpticLevels,
                         testing::Values("cone-box", "cone-pawn", "concave-F", "concave-box", "ellipsoid-box",
                                         "paraboloid-box", "patch-box", "patch-pawn", "vase-box", "wavy-F",
                                         "wavy-box"),
                         [](const auto& each) {
                           std::string name = each.param;
                           name.erase(name.find('-'), 1);
                           return name;
                         });

// ---- What is made by another mirror than it is seen in scores worse.

struct Mutant {
  const char* level;
  const char* what;
  std::function<void(Level&)> change;  // of the level that the sculpture is made by
};

template <typename S>
std::function<void(Level&)> changed(std::function<void(S&)> change) {
  return [=](Level& level) {
    S shape = *level.optic.shape().as<S>();
    change(shape);
    Shape mutant = std::move(shape);
    mutant.clipBy(level.optic.shape().clip());
    level.optic.shape() = mutant;
  };
}

const std::array mutants{
    Mutant{"concave-box", "the radius is 1 % larger",
           changed<SphereMirror>([](SphereMirror& s) { s.radius *= 1.01; })},
    Mutant{"vase-box", "a control radius is 0.05 larger",
           changed<RevolutionMirror>([](RevolutionMirror& s) { s.radii[4] += 0.05; })},
    Mutant{"wavy-box", "the spline is shifted by a control point",
           changed<ExtrusionMirror>([](ExtrusionMirror& s) {
             std::rotate(s.points.begin(), s.points.begin() + 1, s.points.end());
             for (std::size_t i = 0; i < s.points.size(); ++i) s.points[i].x = static_cast<double>(i) - 9;
           })},
    Mutant{"patch-box", "a control height is 0.1 higher",
           changed<PatchMirror>([](PatchMirror& s) { s.heights.at(3, 3) += 0.1; })},
    Mutant{"cone-box", "the eye is 0.2 aside", [](Level& level) { level.camera.eye.x += 0.2; }},
};

TEST(OpticMutants, ScoreWorse) {
  for (const Mutant& mutant : mutants) {
    SCOPED_TRACE(std::string(mutant.level) + ": " + mutant.what);
    const Level level = levelNamed(mutant.level);
    Level wrong = level;
    mutant.change(wrong);
    const MatchReport right = reportOf(level, resultOf(level), 256),
                      worse = reportOf(level, resultOf(wrong), 256);
    EXPECT_GT(worse.p99Px, 1 + right.p99Px);
    EXPECT_NE(gradeOf(worse), MatchGrade::excellent);
  }
}

// Across the caustic the silhouette may still agree; what is folded, and the correspondence, tell.
TEST(OpticMutants, AcrossTheCausticIsFolded) {
  Level level = levelNamed("concave-box");
  double mostFolded = 0;
  for (const double scale : {1.2, 1.6, 2.0, 2.6}) {
    level.sculpture.depthScale = scale;
    const MatchReport report = reportOf(level, resultOf(level), 256);
    mostFolded = std::max(mostFolded, report.foldedShare);
    if (report.foldedShare > 0) {
      EXPECT_NE(gradeOf(report), MatchGrade::excellent) << scale;
    }
  }
  EXPECT_GT(mostFolded, 0.01);
}

}  // namespace
}  // namespace anamorph
