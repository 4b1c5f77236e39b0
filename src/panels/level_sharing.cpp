#include "panels/level_sharing.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "base/error.h"
#include "base/language.h"
#include "base/text.h"
#include "edit/level_files.h"
#include "edit/replacements.h"
#include "level/freeze.h"
#include "level/level_json.h"
#include "panels/file_browser.h"
#include "panels/let_go.h"
#include "pipeline/mirror_files.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

void toClipboard(const Level& level, Editor& editor) {
  if (!ImGui::GetCurrentContext()) return;
  ImGui::SetClipboardText(levelAsText(level, editor.session.path()).c_str());
  const auto* mesh = std::get_if<FileShape>(&level.original.shape);
  editor.status.sayOf(editor.session.level(),
                      mesh && mesh->obj->empty()
                          ? trFormat("The level is on the clipboard, as text; it needs {}, too.",
                                     fs::path(mesh->path).filename().string())
                          : tr("The level is on the clipboard, as text."));
}

std::string joined(const std::string& sentence, const std::string& next) {
  return next.empty() ? sentence : sentence + " " + next;
}

// What was mended of a text, as a sentence; empty: nothing.
std::string mendsText(const TextMends& mends) {
  std::string what;
  const auto add = [&](bool was, const char* text) {
    if (was) what += (what.empty() ? "" : ", ") + std::string(text);
  };
  add(mends.wordsAround, tr("words around it left out"));
  add(mends.quoting, tr("marks of quoting taken away"));
  add(mends.lineEnds, tr("broken lines joined"));
  return what.empty() ? what : trFormat("Mended: {}.", what);
}

const FileShape* fileOf(const Level& level) {
  return std::get_if<FileShape>(&level.original.shape);
}

// In place of the open one, as one step. Meshes of mirrors that the open one has not got are read first, beside the window.
void takeLevel(Editor& editor, Level level, std::string message) {
  if (!takeMirrorFiles(level, editor.session.level())) {
    editor.session.edit(std::move(level));
    editor.status.sayOf(editor.session.level(), std::move(message));
    return;
  }
  editor.session.finishChange();
  editor.job.start(editor.session, tr("Reading the mirror's mesh"),
                   [taken = std::move(level), path = editor.session.path(), message = std::move(message)](
                       const Level&, const Progress& progress) {
                     Level read = taken;
                     const auto warnings = readMirrorFiles(read, path, {}, &progress.token);
                     return EditResult{std::move(read), withRemarks(message, warnings)};
                   });
}

}  // namespace

void copyLevel(Editor& editor) {
  toClipboard(editor.session.level(), editor);
}

bool canCopyWithMesh(const Editor& editor) {
  const FileShape* mesh = fileOf(editor.session.level());
  const LevelResult& result = editor.updater.result();
  return mesh && (!mesh->obj->empty() || (result.shape && result.refined));
}

void copyLevelWithMesh(Editor& editor, UiState& ui) {
  const Level& level = editor.session.level();
  const bool isInside = !fileOf(level)->obj->empty();
  try {
    toClipboard(isInside ? level : withMeshInside(level, *editor.updater.result().shape), editor);
  } catch (const Error& error) {
    ui.notice = Notice{"The mesh is too large for a text", error.what()};
  }
}

void pasteLevel(Editor& editor, UiState& ui) {
  if (!ImGui::GetCurrentContext()) return;
  const char* text = ImGui::GetClipboardText();
  try {
    SentLevel sent = levelFromText(text ? text : "", editor.session.level(), editor.session.path());
    finishEdits(editor, ui);
    const auto missing = findMissingMesh(sent.level, editor.session.path());
    const std::string mended = mendsText(sent.mends);
    editor.status.sayOf(editor.session.level(), mended);
    if (missing) {
      ui.meshQuestion = MeshQuestion{std::move(sent.level), *missing};
      return;
    }
    takeLevel(editor, std::move(sent.level),
              joined(tr("The level has been pasted; Ctrl+Z takes it back."), mended));
  } catch (const Error& error) {
    ui.notice = Notice{"There is no level on the clipboard", error.what()};
  }
}

void askForMissingMesh(const Editor& editor, UiState& ui) {
  ui.meshQuestion.reset();
  if (findMissingMesh(editor.session.level(), editor.session.path())) askForMesh(editor, ui);
}

void askForMesh(const Editor& editor, UiState& ui) {
  const Level& level = editor.session.level();
  if (const FileShape* mesh = fileOf(level))
    ui.meshQuestion = MeshQuestion{level, modelPath(*mesh, editor.session.path())};
}

void giveMesh(const fs::path& mesh, Editor& editor, UiState& ui) {
  if (!ui.meshQuestion) return;
  Level level = following(ui.meshQuestion->level);  // what is frozen was the missing one's
  ui.meshQuestion.reset();
  auto& file = std::get<FileShape>(level.original.shape);
  file = {.path = meshNameFor(mesh, editor.session.path()), .up = file.up};
  takeLevel(editor, std::move(level), trFormat("The original is {}; Ctrl+Z takes it back.", mesh.string()));
}

void answerMeshQuestion(MeshQuestion::Answer answer, Editor& editor, UiState& ui) {
  using Answer = MeshQuestion::Answer;
  if (answer == Answer::browse)
    return browseFiles(ui.browser, FilePurpose::findMesh,
                       editor.session.isInstalled() ? fs::path() : editor.session.path());
  const MeshQuestion question = *std::exchange(ui.meshQuestion, std::nullopt);
  if (answer == Answer::cancel) return;
  takeLevel(editor, withStandIn(question.level),
            trFormat("A pawn stands in for {}; Ctrl+Z takes it back.", question.mesh.filename().string()));
}

}  // namespace anamorph
