// The file browser's ways to folders: the path as buttons, and places that are often wanted.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "panels/browser_state.h"
#include "panels/look.h"

namespace anamorph {

/// Whether `folder` is `root` or below it; both absolute and without dots.
bool isBelow(const std::filesystem::path& folder, const std::filesystem::path& root);

/// Puts it first among the recent folders.
void rememberFolder(FileBrowser& browser, const std::filesystem::path& folder);

/// Where a file goes that nothing else is known of: the newest of the recent folders, else home.
std::filesystem::path usualFolder(const FileBrowser& browser);

/// Where a file made of this level is proposed to go: into the folder of the last one, else the usual one, under the
/// level's name and this one: "plane-sheet.pdf".
std::filesystem::path proposedExport(const FileBrowser& browser, const std::filesystem::path& lastFolder,
                                     const std::filesystem::path& level, const std::string& name);

/// A button up, the parts of the path, and in narrow windows a list of places. Returns where to go.
std::optional<std::filesystem::path> drawPathRow(const FileBrowser& browser, const Look& look);

/// Whether there is room for the places beside the files.
bool placesAreBeside(const Look& look);

/// The places as a column, that ends so far above the lower edge. Returns where to go.
std::optional<std::filesystem::path> drawPlaces(const FileBrowser& browser, const Look& look, float below);

}  // namespace anamorph
