// The match report in words and colours, for the menu bar and the preview.
#pragma once

#include <string>
#include <vector>

#include <imgui.h>

#include "edit/live_updater.h"
#include "panels/look.h"

namespace anamorph {

struct MatchPart {
  const char* name;
  std::string value;
  bool good;         ///< as in method section 6
  const char* help;  ///< one line
};

struct MatchScore {
  enum class Tone { good, middling, bad, unknown };

  double fraction = 0;  ///< silhouette IoU, 0..1
  std::string percent;  ///< "99.95 %", "..." while it is not known
  std::string word;     ///< "excellent", "match", "partial", "poor", ...
  Tone tone = Tone::unknown;
  std::string help;
  std::vector<MatchPart> parts;
};

MatchScore matchScore(const LevelResult& result);
/// "match 99.95 %  excellent", in the chosen language.
std::string scoreText(const MatchScore& score);
ImVec4 scoreColor(const MatchScore& score, Theme theme);

}  // namespace anamorph
