// Choosing a file, to open or to save: a browser of the program's own, the same on every system and usable by
// keys alone. Plain data between frames:
//
//   browseFiles(browser, FilePurpose::saveImage, "folder/or/file.png");      ... frames, until ...
//   if (auto path = takeChosenFile(browser, FilePurpose::saveImage)) ...
//
// Typing filters (or is the name to save as); arrows and Enter choose, Backspace in an empty field goes up,
// Esc closes. What has a / or ~ in it is a path. It only chooses: reading and writing are the caller's.
#pragma once

#include <filesystem>
#include <optional>

#include "panels/browser_state.h"

namespace anamorph {

/// Opens the browser. `start`: a folder, or a file whose folder is shown and, to save, whose name is
/// proposed; empty: the last folder, or home.
void browseFiles(FileBrowser& browser, const FilePurpose& purpose, const std::filesystem::path& start = {});

/// The file that was chosen for this, once.
std::optional<std::filesystem::path> takeChosenFile(FileBrowser& browser, const FilePurpose& purpose);

/// For a window that opened the browser and waits: the same, once; `waiting` ends with the file, and when the
/// browser was closed without one.
std::optional<std::filesystem::path> awaitChosenFile(FileBrowser& browser, const FilePurpose& purpose,
                                                     bool& waiting);

}  // namespace anamorph
