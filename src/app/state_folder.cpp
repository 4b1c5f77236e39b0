#include "app/state_folder.h"

#include <cstdlib>

namespace anamorph {

std::filesystem::path stateFolder() {
  namespace fs = std::filesystem;
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  const fs::path base =
      state && *state ? fs::path(state) : fs::path(home && *home ? home : ".") / ".local" / "state";
  return base / "anamorph";
}

}  // namespace anamorph
