#include "panels/match_score.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/language.h"
#include "panels/style.h"

namespace anamorph {
namespace {

// Never rounded up to a perfect score.
std::string percent(double fraction, int digits = 2) {
  const double unit = std::pow(10, -digits);
  const double shown = fraction < 1 ? std::min(100 * fraction, 100 - unit) : 100;
  std::string text = shownNumber(shown, fmt::format(".{}f", digits));
  return text.append(" %");
}

MatchScore::Tone toneOf(MatchGrade grade) {
  switch (grade) {
    case MatchGrade::excellent:
    case MatchGrade::match:
      return MatchScore::Tone::good;
    case MatchGrade::partial:
      return MatchScore::Tone::middling;
    case MatchGrade::poor:
    case MatchGrade::none:
      return MatchScore::Tone::bad;
    case MatchGrade::tooSmall:
      break;
  }
  return MatchScore::Tone::unknown;
}

}  // namespace

MatchScore matchScore(const LevelResult& result) {
  MatchScore score;
  if (result.problem) {
    score.percent = "0 %";
    score.word = matchGradeName(MatchGrade::none);
    score.tone = MatchScore::Tone::bad;
    score.help = *result.problem;
    return score;
  }
  if (!result.match) {
    score.percent = "...";
    score.help = "It is being measured.";
    return score;
  }
  const MatchReport& report = result.match->report;
  const MatchGrade grade = gradeOf(report);
  const MatchBounds& good = boundsOf(MatchGrade::match);
  score.fraction = report.silhouetteIou;
  // While something moves the picture compared is coarse, and so is the figure.
  score.percent = percent(report.silhouetteIou, result.refined ? 2 : 1);
  score.word = result.complete ? matchGradeName(grade) : result.refined ? "being measured" : "live";
  // A colour is a verdict, and there is none before it is measured anew.
  score.tone = result.complete ? toneOf(grade) : MatchScore::Tone::unknown;
  score.help = findMatchProblem(report).value_or(
      "How well the reflection agrees with the original seen directly: the "
      "share of pixels that both show.");
  if (grade == MatchGrade::tooSmall) score.percent = std::string(1, '-');
  // What the lessons speak of comes first: where there is little room, the others are left to the tooltip.
  score.parts = {
      {"Hidden", shownFormat("{:.1f} %", 100 * report.hiddenShare), report.hiddenShare == 0,
       "Of the original's pixels: the sculpture itself or the floor stands in the way. Raise the eye, or the "
       "original."},
      {"Point error", report.comparedPixels > 0 ? shownFormat("{:.2f} px", report.p99Px) : "-",
       report.comparedPixels > 0 && report.p99Px <= good.p99Px,
       "Correspondence: how far a reflected point is from where it should be; 99 of 100 points are nearer."},
      {"Missed", shownFormat("{:.1f} %", 100 * report.missedShare), report.missedShare == 0,
       "Of the original's pixels: there is no mirror. Make the mirror larger or move the original."},
      {"Folded", shownFormat("{:.1f} %", 100 * report.foldedShare), report.foldedShare == 0,
       "Of the original: neighbouring rays have crossed before they reach this part of the sculpture, so it "
       "is left out. Stay nearer to the mirror, or go beyond with the depth offset."},
      {"Outline", contourText(report.contourPx), report.contourPx <= good.contourPx,
       "How far the outlines of original and reflection are apart; 99 of 100 points of them are nearer."},
      {"Beside", shownFormat("{:.1f} %", 100 * report.extraShare), report.extraShare <= good.extraShare,
       "Pixels that show the sculpture beside the original, over the original's pixels."},
      {"Silhouette", percent(report.silhouetteIou), report.contourPx <= good.contourPx,
       "Pixels that original and reflection both show, of those that either shows (IoU)."},
  };
  // What makes it worse comes before what lessons speak of; while it changes, each keeps its place.
  if (result.complete) {
    std::stable_partition(score.parts.begin(), score.parts.end(),
                          [](const MatchPart& part) { return !part.good; });
  }
  return score;
}

std::string scoreText(const MatchScore& score) {
  const std::string match = matchGradeName(MatchGrade::match);
  // A word of its own where a language has another one for the grade than for what is measured.
  if (score.word == match) return trFormat("match {}  match", score.percent);
  return trFormat("match {}  {}", score.percent, tr(score.word));
}

ImVec4 scoreColor(const MatchScore& score, Theme theme) {
  switch (score.tone) {
    case MatchScore::Tone::good:
      return ink::good(theme);
    case MatchScore::Tone::middling:
      return ink::middling(theme);
    case MatchScore::Tone::bad:
      return ink::bad(theme);
    case MatchScore::Tone::unknown:
      break;
  }
  return ink::quiet(theme);
}

}  // namespace anamorph
