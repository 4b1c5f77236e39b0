// The steps of the file browser, between its keys and buttons and its state (browser_state.h).
#pragma once

#include <filesystem>
#include <string>

#include "panels/browser_state.h"
#include "panels/keys.h"

namespace anamorph {

/// Whether a text is the path of a file rather than a filter or a name.
bool isPath(const std::string& text);
/// Where it leads from the folder that is shown; ~ is home.
std::filesystem::path pathOf(const FileBrowser& b, const std::string& text);
bool isFolder(const std::filesystem::path& path);

/// Puts a text into the field.
void setBrowserText(FileBrowser& b, const std::string& text);
/// Where the text is the path of a folder and something behind it: enters the folder and keeps the rest.
void enterTypedFolder(FileBrowser& b);
/// Brings the rows up to date with filter and check boxes.
void chooseShown(FileBrowser& b);
/// Shows another folder; where it cannot be listed, `problem` says why and the old one stays.
void enterFolder(FileBrowser& b, const std::filesystem::path& path);
/// A click or an arrow; to save, a file's name comes into the field.
void selectRow(FileBrowser& b, int row);
/// Enter, or the first button: enters a folder, makes one, asks, chooses.
void acceptChoice(FileBrowser& b);
/// Esc, or the second button: out of a question, out of naming a folder, out of the browser.
void leaveStep(FileBrowser& b);
/// The keys typed since the last frame. Backspace goes up if the field was empty before it.
void handleBrowserKeys(FileBrowser& b, const DialogKeys& typed, bool fieldWasEmpty, int rowsInSight);

}  // namespace anamorph
