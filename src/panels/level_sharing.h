// A level goes from one person to another as text or as a file, and its mesh may have stayed behind: copying, pasting,
// and the question where the mesh is.
//
//   paste, open --mesh is not there?--> question --browse, stand-in--> one step to undo
//                                               `--cancel--> not pasted; or open, without a sculpture
#pragma once

#include <filesystem>

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

/// The whole level as text to the clipboard, its mesh as it is: inside, or by its file's name.
void copyLevel(Editor& editor);
/// The same with the mesh of its file inside; too large a mesh is a notice.
void copyLevelWithMesh(Editor& editor, UiState& ui);
bool canCopyWithMesh(const Editor& editor);

/// The level on the clipboard in place of this one; bad text is a notice.
void pasteLevel(Editor& editor, UiState& ui);

/// Asks where the mesh of the open level is, if it is not there. To be called when a level has been opened.
void askForMissingMesh(const Editor& editor, UiState& ui);
/// Asks whatever is wrong with the mesh.
void askForMesh(const Editor& editor, UiState& ui);

void answerMeshQuestion(MeshQuestion::Answer answer, Editor& editor, UiState& ui);
/// The mesh that was asked for, as it is: nothing is fitted.
void giveMesh(const std::filesystem::path& mesh, Editor& editor, UiState& ui);

}  // namespace anamorph
