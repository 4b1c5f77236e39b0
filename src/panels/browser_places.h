// The file browser's ways to folders: the path as buttons, and places that are often wanted.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "panels/ui_state.h"

namespace anamorph {

/// Whether `folder` is `root` or below it; both absolute and without dots.
bool isBelow(const std::filesystem::path& folder, const std::filesystem::path& root);

/// Puts it first among the recent folders.
void rememberFolder(UiState& ui, const std::filesystem::path& folder);

/// Where a file goes that nothing else is known of: the newest of the recent folders, else home.
std::filesystem::path usualFolder(const UiState& ui);

/// Where a file made of this level is proposed to go: into the folder of the last one, else the usual one, under the
/// level's name and this one: "plane-sheet.pdf".
std::filesystem::path proposedExport(const UiState& ui, const std::filesystem::path& lastFolder,
                                     const std::filesystem::path& level, const std::string& name);

/// A button up, the parts of the path, and in narrow windows a list of places. Returns where to go.
std::optional<std::filesystem::path> drawPathRow(UiState& ui);

/// Whether there is room for the places beside the files.
bool placesAreBeside(const UiState& ui);

/// The places as a column, that ends so far above the lower edge. Returns where to go.
std::optional<std::filesystem::path> drawPlaces(UiState& ui, float below);

}  // namespace anamorph
