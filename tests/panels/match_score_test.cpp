#include "panels/match_score.h"

#include <gtest/gtest.h>

#include <memory>

namespace anamorph {
namespace {

LevelResult measured(double iou, bool refined = true) {
  auto match = std::make_shared<Match>();
  match->report.width = match->report.height = 100;
  match->report.originalPixels = 1000;
  match->report.silhouetteIou = iou;
  match->report.contourPx = 9 * (1 - iou);
  match->report.comparedPixels = 100;
  match->report.triangleAgreement = iou > 0.5 ? 1 : 0;
  LevelResult result;
  result.match = match;
  result.refined = result.complete = refined;
  return result;
}

TEST(MatchScore, IsUnknownBeforeItIsMeasured) {
  const MatchScore score = matchScore({});
  EXPECT_EQ(score.percent, "...");
  EXPECT_EQ(score.tone, MatchScore::Tone::unknown);
  EXPECT_TRUE(score.parts.empty());
}

TEST(MatchScore, OfAProblemIsNothingAndSaysWhy) {
  LevelResult result = measured(1);
  result.problem = "the eye is on the surface of the mirror.";
  const MatchScore score = matchScore(result);
  EXPECT_EQ(score.fraction, 0);
  EXPECT_EQ(score.percent, "0 %");
  EXPECT_EQ(score.word, "none");
  EXPECT_EQ(score.tone, MatchScore::Tone::bad);
  EXPECT_EQ(score.help, *result.problem);
}

TEST(MatchScore, IsNeverRoundedUpToPerfect) {
  EXPECT_EQ(matchScore(measured(1)).percent, "100.00 %");
  EXPECT_EQ(matchScore(measured(0.99999)).percent, "99.99 %");
  EXPECT_EQ(matchScore(measured(0.999953)).percent, "99.99 %");
  EXPECT_EQ(matchScore(measured(0.5)).percent, "50.00 %");
  EXPECT_EQ(matchScore(measured(0)).percent, "0.00 %");
  EXPECT_NE(matchScore(measured(0.9997, false)).percent, "100.0 %");
}

TEST(MatchScore, GradesInWordAndColour) {
  EXPECT_EQ(matchScore(measured(1)).word, "excellent");
  EXPECT_EQ(matchScore(measured(1)).tone, MatchScore::Tone::good);
  EXPECT_EQ(matchScore(measured(0.7)).word, "partial");
  EXPECT_EQ(matchScore(measured(0.7)).tone, MatchScore::Tone::middling);
  EXPECT_EQ(matchScore(measured(0.3)).word, "poor");
  EXPECT_EQ(matchScore(measured(0.3)).tone, MatchScore::Tone::bad);
  EXPECT_EQ(matchScore(measured(0.7, false)).word, "live");
  EXPECT_EQ(matchScore(measured(1, false)).tone, MatchScore::Tone::unknown) << "the old figure is no verdict";
  LevelResult refined = measured(1);
  refined.complete = false;
  EXPECT_EQ(matchScore(refined).word, "being measured");
  EXPECT_EQ(matchScore(refined).tone, MatchScore::Tone::unknown);
}

TEST(MatchScore, OfAnOriginalThatCoversFewPixelsIsNoGradeButAdvice) {
  LevelResult result = measured(1);
  auto match = std::make_shared<Match>(*result.match);
  match->report.originalPixels = 12;
  result.match = match;
  const MatchScore score = matchScore(result);
  EXPECT_EQ(score.word, "too small");
  EXPECT_EQ(score.percent, "-");
  EXPECT_EQ(score.tone, MatchScore::Tone::unknown);
  EXPECT_EQ(score.help,
            "from this eye the original covers 12 pixels: come nearer or narrow the field of view");
}

TEST(MatchScore, PartsAreGoodOrNotEachByItself) {
  LevelResult result = measured(1);
  auto match = std::make_shared<Match>(*result.match);
  match->report.hiddenShare = 0.2;
  result.match = match;
  const MatchScore score = matchScore(result);
  ASSERT_EQ(score.parts.size(), 7u);
  for (const MatchPart& part : score.parts)
    EXPECT_EQ(part.good, std::string(part.name) != "Hidden") << part.name;
  EXPECT_EQ(score.parts[0].value, "20.0 %");
  EXPECT_NE(score.word, "excellent");
}

}  // namespace
}  // namespace anamorph
