// The windows that lie over the panels, and all that the keyboard can go to.
#pragma once

#include <string>
#include <vector>

#include "panels/ui_state.h"

namespace anamorph {

/// The windows of Dear ImGui that can have the keyboard now, in the order of F6.
std::vector<std::string> reachableWindows(const UiState& ui);

/// Closes those that can be closed. Returns whether there was one.
bool closeWindows(UiState& ui);

}  // namespace anamorph
