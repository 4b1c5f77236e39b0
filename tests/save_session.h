// What SaveJob does with a session, in the test's own thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "edit/session.h"

namespace anamorph::testing {

/// Returns what could not be kept of the file that was replaced. Throws Error; the session stays as it was then.
inline std::vector<std::string> saveTo(Session& session, const std::filesystem::path& path) {
  const SavedLevel saved = session.prepareSave(path);
  std::vector<std::string> lost = saveLevel(path, saved.level);
  session.finishSave(saved, timeOf(path));
  return lost;
}

}  // namespace anamorph::testing
