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
  return fmt::format("{:.{}f} %", shown, digits);
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
  score.fraction = report.silhouetteIou;
  // While something moves the picture compared is coarse, and so is the figure.
  score.percent = percent(report.silhouetteIou, result.refined ? 2 : 1);
  score.word = result.refined ? matchGradeName(grade) : "live";
  score.tone = grade == MatchGrade::none      ? MatchScore::Tone::bad
               : grade == MatchGrade::partial ? MatchScore::Tone::middling
                                              : MatchScore::Tone::good;
  score.help =
      "How well the reflection agrees with the original seen directly: the share of pixels that both show.";
  score.parts = {
      {"Silhouette", percent(report.silhouetteIou), report.silhouetteIou >= 0.99,
       "Pixels that original and reflection both show, of those that either shows (IoU)."},
      {"Point error", report.comparedPixels > 0 ? fmt::format("{:.2f} px", report.p99Px) : "-",
       report.comparedPixels > 0 && report.p99Px <= 1,
       "Correspondence: how far a reflected point is from where it should be; 99 of 100 points are nearer."},
      {"Hidden", fmt::format("{:.1f} %", 100 * report.hiddenShare), report.hiddenShare == 0,
       "Of the original's pixels: the sculpture itself stands between the eye and the mirror. Raise the "
       "eye."},
      {"Missed", fmt::format("{:.1f} %", 100 * report.missedShare), report.missedShare == 0,
       "Of the original's pixels: there is no mirror. Make the mirror larger or move the original."},
  };
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
