// A sculpture that is frozen: it is made from what was kept, to the last bit; the rest of the level is seen and compared
// as it is.

#include "level/freeze.h"

#include <gtest/gtest.h>

#include <string>

#include "pipeline/changing_levels.h"
#include "pipeline/evaluator.h"

namespace anamorph {
namespace {

using namespace testing;

EvaluationInput inputOf(const Level& level) {
  return {level, "level.json", 32};
}

LevelResult evaluated(const Level& level) {
  return *Evaluator().evaluate(inputOf(level), 2);
}

void expectSameSculpture(const LevelResult& a, const LevelResult& b) {
  EXPECT_EQ(a.sculpture.sculpture->mesh, b.sculpture.sculpture->mesh);
  EXPECT_EQ(a.sculpture.sculpture->original, b.sculpture.sculpture->original);
  EXPECT_EQ(a.sculpture.sculpture->sourceTriangle, b.sculpture.sculpture->sourceTriangle);
}

void expectSameMatch(const LevelResult& a, const LevelResult& b) {
  ASSERT_EQ(a.match == nullptr, b.match == nullptr);
  if (!a.match) return;
  EXPECT_EQ(a.match->classes, b.match->classes);
  const MatchReport &r = a.match->report, &s = b.match->report;
  EXPECT_EQ(r.silhouetteIou, s.silhouetteIou);
  EXPECT_EQ(r.p99Px, s.p99Px);
  EXPECT_EQ(r.meanPx, s.meanPx);
  EXPECT_EQ(r.triangleAgreement, s.triangleAgreement);
  EXPECT_EQ(r.contourPx, s.contourPx);
}

class FrozenLevels : public ::testing::TestWithParam<unsigned> {
 protected:
  Random random_{GetParam()};
  Level level_ = changed(quickLevels()[GetParam() % 3], random_, 0.3);
};

TEST_P(FrozenLevels, FreezingAloneChangesNothing) {
  const LevelResult before = evaluated(level_), after = evaluated(frozen(level_));
  expectSameSculpture(before, after);
  expectSameMatch(before, after);
  EXPECT_EQ(before.problem, after.problem);
  EXPECT_EQ(*before.previews.reflection, *after.previews.reflection);
}

TEST_P(FrozenLevels, StayAsTheyAreWhateverMoves) {
  Evaluator evaluator;
  const LevelResult before = *evaluator.evaluate(inputOf(level_), 2);
  if (before.problem) return;
  Level kept = frozen(level_);
  for (int i = 0; i < 4; ++i) {
    kept = changed(kept, random_, 0.2);
    const LevelResult after = *evaluator.evaluate(inputOf(kept), 2);
    expectSameSculpture(before, after);
    EXPECT_EQ(before.sculpture, after.sculpture) << "nor is it made anew";
    const LevelResult afresh = evaluated(kept);
    expectSameSculpture(before, afresh);
    expectSameMatch(after, afresh);
    EXPECT_EQ(after.problem, findProblem(kept, after.original.box));
    // What is seen is the frozen sculpture with the eye and the mirror of now.
    EXPECT_EQ(*after.previews.original, *evaluated(following(kept)).previews.original);
    const SceneInput scene = makeReflectionScene(following(kept), before.sculpture);
    EXPECT_EQ(makeReflectionScene(kept, after.sculpture), scene);
  }
  const LevelResult again = *evaluator.evaluate(inputOf(following(kept)), 2);
  expectSameSculpture(again, evaluated(following(kept)));
  expectSameMatch(again, evaluated(following(kept)));
}

TEST_P(FrozenLevels, AreTheSameFromTheirFile) {
  const Level kept = changed(frozen(level_), random_, 0.2);
  const Level read = parseLevel(formatLevel(kept), "frozen.json").level;
  EXPECT_EQ(read, kept);
  const LevelResult before = evaluated(kept), after = evaluated(read);
  expectSameSculpture(before, after);
  expectSameMatch(before, after);
}

// The commands have the mesh of the original alone.
TEST_P(FrozenLevels, AreTheSameFromTheCommands) {
  const Level kept = changed(frozen(level_), random_, 0.2);
  const auto shape = loadOriginal(kept.original.shape, "level.json").mesh;
  const LevelResult finished = *finishLevel(kept, placeOriginal(*shape, kept), 2);
  const LevelResult wanted = evaluated(kept);
  expectSameSculpture(finished, wanted);
  EXPECT_EQ(finished.problem, wanted.problem);
  EXPECT_EQ(finished.warnings, wanted.warnings);
  if (wanted.problem) return;
  const auto [width, height] = pictureSize(kept.grid, matchSize);
  const Match match = matchLevel(finished, width, height, 2);
  EXPECT_EQ(match.classes, wanted.match->classes);
  EXPECT_EQ(match.report.p99Px, wanted.match->report.p99Px);
}

INSTANTIATE_TEST_SUITE_P(Seeds, FrozenLevels, ::testing::Range(0u, 12u));

TEST(FrozenSculpture, IsRightFromOnePointOnly) {
  for (Level level : quickLevels()) {
    SCOPED_TRACE(level.text->title);
    level.sculpture.depthScale = 0.6;
    level.camera.eye.z += 3;
    const LevelResult right = evaluated(level);
    ASSERT_GT(right.match->report.silhouetteIou, 0.99);
    Level aside = frozen(level);
    aside.camera.eye.x += 4;
    const LevelResult wrong = evaluated(aside);
    EXPECT_LT(wrong.match->report.silhouetteIou, 0.9);
    EXPECT_GT(wrong.match->report.p99Px, 3);
    aside.camera.eye = level.camera.eye;
    expectSameMatch(evaluated(aside), right);
  }
}

// With k = 1 a flat mirror asks for the mirror image, which is right from everywhere.
TEST(FrozenSculpture, OfAFlatMirrorIsRightFromEverywhereWithKOne) {
  Level level = frozen(quickLevels()[0]);
  level.camera.eye += Vector(3, 1, 2);
  EXPECT_GT(evaluated(level).match->report.silhouetteIou, 0.99);
}

// Points of the original are compared with where they are now: moved along the line of sight it covers the
// same pixels nearly, but each of its points is seen elsewhere.
TEST(FrozenSculpture, IsComparedWithTheOriginalWhereThatIsNow) {
  Level level = frozen(quickLevels()[0]);
  level.original.placement.rotationDegrees.z += 180;  // a box covers itself then
  const MatchReport report = evaluated(level).match->report;
  EXPECT_GT(report.silhouetteIou, 0.99);
  EXPECT_GT(report.p99Px, 50) << "every point is at the other end";
  EXPECT_LT(report.triangleAgreement, 0.5);
}

// An eye on the mirror is no reason for the sculpture to vanish.
TEST(FrozenSculpture, StaysWhenNothingCanBeCompared) {
  Level level = quickLevels()[1];
  const LevelResult before = evaluated(level);
  level = frozen(level);
  level.camera.eye = pointAt(level.optic.shape(), 0.3, 0.6);
  const LevelResult inside = evaluated(level);
  EXPECT_TRUE(inside.problem);
  EXPECT_FALSE(inside.match);
  expectSameSculpture(before, inside);
  EXPECT_TRUE(evaluated(following(level)).sculpture.sculpture->mesh.triangles.empty());
}

TEST(FrozenSculpture, SaysForWhichEyeItWasMade) {
  Level level = frozen(quickLevels()[0]);
  level.camera.eye.x += 1;
  const auto sentence = frozenSentence(level);
  ASSERT_TRUE(sentence);
  EXPECT_NE(sentence->find("(0, -11.9, 6.5)"), std::string::npos) << *sentence;
  EXPECT_EQ(evaluated(level).warnings.back(), *sentence);
  EXPECT_FALSE(frozenSentence(following(level)));
}

}  // namespace
}  // namespace anamorph
