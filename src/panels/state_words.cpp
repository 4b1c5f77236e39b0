#include "panels/state_words.h"

namespace anamorph {

const char* stateWords(const LevelResult& result, bool busy) {
  if (result.problem) return hasSculpture(result) ? "nothing to compare" : "no sculpture";
  if (!result.complete && !busy) return "not finished";  // it was cancelled
  if (!result.sculpture.sculpture) return "loading";
  if (!result.refined) return "following, not refined yet";
  const bool refines = result.level.sculpture.tolerancePixels > 0;
  if (!result.complete) return refines ? "refined, being measured" : "not refined, being measured";
  return refines ? "refined and measured" : "not refined, measured";
}

}  // namespace anamorph
