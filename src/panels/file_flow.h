// What the File menu does: the way from a wish through the questions that it raises to the deed.
//
//   wish: open, new, quit --unsaved changes?--> question --save, or not--> done by the GUI or the window
//                                                   `--cancel--> nothing has happened
//   and then:        quit --files being written?--> question --wait, or not--> done by the window
//
// Files are read and written in the session; what goes wrong there is said and changes nothing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

/// Opens the browser for a level.
void chooseLevel(Editor& editor, UiState& ui);
/// Saves the level to its file; asks for one when it has none, or one that is not to be replaced.
void saveCurrent(Editor& editor, UiState& ui);
void saveCurrentAs(Editor& editor, UiState& ui);

/// Opens the browser for a mesh that takes the original's place.
void chooseOriginal(Editor& editor, UiState& ui);
/// Reads a mesh in the background and puts it in the original's place, fitted into its box; in place of another mesh
/// file it keeps rotation and scale (withAnotherMesh). Which way is up is guessed, and said where that turns it: one step
/// to undo, before the import itself. For a scene of the thesis it stays as it is, as that scene means it.
void importOriginal(Editor& editor, const std::filesystem::path& mesh,
                    std::optional<ModelUp> up = std::nullopt);

/// Opens the browser for a mesh whose surface takes the mirror's place.
void chooseMirror(Editor& editor, UiState& ui);

/// Files that were dropped on the window: a mesh takes the original's place, or is the one that was asked for, a level is
/// opened. Of several the first that is either.
void acceptFiles(const std::vector<std::filesystem::path>& files, Editor& editor, UiState& ui);

/// Puts a level of one's own first among the recent ones, and its folder among those.
void rememberLevel(UiState& ui, const std::filesystem::path& path);

/// The files that would not be there if the program ended now.
std::vector<std::string> filesBeingWritten(const Editor& editor, const UiState& ui);
/// One of them could not be written. A wish to quit that has waited for it is given up, and a notice says why.
void giveUpQuitting(UiState& ui, const std::string& problem);

/// Once a frame, after the panels: does what the browser chose, and lets only those of the requests `open`,
/// `startNew` and `quit` stand that may be served now. The others wait for the questions about unsaved
/// changes and about files that are being written.
void settleRequests(Editor& editor, UiState& ui);

}  // namespace anamorph
