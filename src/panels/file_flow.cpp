#include "panels/file_flow.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "base/error.h"
#include "base/folder.h"
#include "base/language.h"
#include "base/text.h"
#include "edit/level_files.h"
#include "edit/mesh_import.h"
#include "edit/mirror_import.h"
#include "geometry/mesh_files.h"
#include "level/level_json.h"
#include "level/surface_files.h"
#include "panels/browser_places.h"
#include "panels/file_browser.h"
#include "panels/let_go.h"
#include "panels/level_sharing.h"
#include "panels/view_mouse.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

// "My first column!" -> "my-first-column"
std::string fileNameOf(const std::string& title) {
  std::string name;
  for (const char c : lowerCase(title)) {
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
      name += c;
    } else if (!name.empty() && name.back() != '-') {
      name += '-';
    }
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name.empty() ? "level" : name.substr(0, 40);
}

// Where a level of one's own may go: beside the last one, never among the installed ones.
fs::path proposedFile(const Editor& editor, const UiState& ui) {
  const fs::path& path = editor.session.path();
  const bool own = !path.empty() && !editor.session.isInstalled();
  if (own && !editor.session.isThesisScene()) return path;
  const fs::path name = path.empty() ? fs::path(fileNameOf(editor.session.level().text->title) + ".json")
                                     : fs::path(path.stem().string() + "-copy.json");
  if (own) return path.parent_path() / name;
  return usualFolder(ui.browser) / name;
}

// Says what came of it, when something has.
void settleSave(Editor& editor, UiState& ui, double patienceSeconds) {
  const std::optional<SaveOutcome> outcome = editor.saving.take(editor.session, patienceSeconds);
  if (!outcome) return;
  editor.status.clear();  // that it is being written
  if (outcome->changedElsewhere && outcome->isOfAnEarlierLevel) {
    ui.unsaved.reset();
    ui.notice = Notice{"The level could not be saved",
                       trFormat("{} has been changed by another program meanwhile, and was left as it is.",
                                outcome->path.string())};
  } else if (outcome->changedElsewhere) {
    browseFiles(ui.browser, FilePurpose::saveLevel, outcome->path);
    ui.browser.problem = trFormat(
        "{} has been changed by another program since it was opened or saved here. Replace it, or "
        "save under another name.",
        outcome->path.filename().string());
  } else if (!outcome->failure.empty()) {
    ui.unsaved.reset();
    ui.finish.reset();
    ui.notice = Notice{"The level could not be saved", outcome->failure};
  } else {
    rememberLevel(ui, outcome->path);
    editor.status.sayOf(editor.session.level(),
                        withRemarks(trFormat("Saved: {}", outcome->path.string()), outcome->lost));
  }
}

// `mayReplace`: also what another program wrote there.
void saveTo(const fs::path& path, bool mayReplace, Editor& editor, UiState& ui) {
  constexpr double patience = 0.05;  // seconds; most files are written in less, and then nothing flickers
  if (editor.saving.busy()) {
    ui.saveNext = SaveWish{path, mayReplace, editor.session.generation()};
    editor.status.say(trFormat("{} is still being written.", editor.saving.path().string()));
    return;
  }
  editor.saving.start(editor.session, path, mayReplace ? std::nullopt : editor.session.fileTime());
  settleSave(editor, ui, patience);
}

// Of another level it is not wanted any more.
void saveWhatWaits(Editor& editor, UiState& ui) {
  if (!ui.saveNext || editor.saving.busy()) return;
  const SaveWish wish = *std::exchange(ui.saveNext, std::nullopt);
  if (wish.generation == editor.session.generation()) saveTo(wish.path, wish.mayReplace, editor, ui);
}

// A level is saved over its own file, but never over its meshes.
std::vector<fs::path> filesToKeep(const Editor& editor, const FilePurpose& purpose) {
  const fs::path& path = editor.session.path();
  std::vector<fs::path> files;
  if (!path.empty() && purpose != FilePurpose::saveLevel) files.push_back(path);
  if (auto mesh = meshFileOf(editor.session.level(), path)) files.push_back(std::move(*mesh));
  for (fs::path& surface : surfaceFilesOf(editor.session.level(), path)) files.push_back(std::move(surface));
  return files;
}

void takeMirror(Editor& editor, const fs::path& mesh) {
  editor.session.finishChange();
  const fs::path& path = editor.session.path();
  editor.job.start(
      editor.session, trFormat("Reading {}", mesh.filename().string()),
      [import = MirrorImport{meshNameFor(mesh, path), path}](const Level& level, const Progress& progress) {
        return importMirror(import, level, progress);
      });
}

void serveBrowser(Editor& editor, UiState& ui) {
  if (ui.browser.open) ui.browser.kept = filesToKeep(editor, ui.browser.purpose);
  if (const auto path = takeChosenFile(ui.browser, FilePurpose::openLevel)) ui.requests.open = *path;
  if (const auto path = takeChosenFile(ui.browser, FilePurpose::openMesh)) importOriginal(editor, *path);
  if (const auto path = takeChosenFile(ui.browser, FilePurpose::openMirror)) takeMirror(editor, *path);
  if (const auto path = takeChosenFile(ui.browser, FilePurpose::findMesh)) giveMesh(*path, editor, ui);
  if (const auto path = takeChosenFile(ui.browser, FilePurpose::saveLevel)) saveTo(*path, true, editor, ui);
}

std::optional<UnsavedQuestion> takeWish(UiRequests& requests) {
  using Next = UnsavedQuestion::Next;
  UnsavedQuestion wish;
  if (std::exchange(requests.quit, false)) {
    wish.next = Next::quit;
  } else if (const auto path = std::exchange(requests.open, std::nullopt)) {
    wish.path = *path;
  } else if (std::exchange(requests.startNew, false)) {
    wish.next = Next::startNew;
  } else {
    return std::nullopt;
  }
  return wish;
}

void grant(const UnsavedQuestion& wish, UiState& ui) {
  if (wish.next == UnsavedQuestion::Next::quit) ui.finish = FinishQuestion{};
  ui.requests.startNew = wish.next == UnsavedQuestion::Next::startNew;
  if (wish.next == UnsavedQuestion::Next::open) ui.requests.open = wish.path;
}

// The last question before the end; without files it is none.
void settleFinish(const Editor& editor, UiState& ui) {
  if (!ui.finish) return;
  using Answer = FinishQuestion::Answer;
  const bool written = filesBeingWritten(editor, ui).empty();
  if (!written && ui.finish->answer != Answer::stop) return;
  ui.requests.quit = true;
  ui.finish.reset();
}

}  // namespace

void chooseLevel(Editor& editor, UiState& ui) {
  finishEdits(editor, ui);
  const fs::path& path = editor.session.path();
  browseFiles(ui.browser, FilePurpose::openLevel, editor.session.isInstalled() ? fs::path() : path);
}

void saveCurrent(Editor& editor, UiState& ui) {
  const fs::path path = editor.session.path();
  if (path.empty() || editor.session.isThesisScene() || editor.session.isInstalled())
    return saveCurrentAs(editor, ui);
  finishEdits(editor, ui);
  saveTo(path, false, editor, ui);
}

void saveCurrentAs(Editor& editor, UiState& ui) {
  finishEdits(editor, ui);
  browseFiles(ui.browser, FilePurpose::saveLevel, proposedFile(editor, ui));
}

void chooseOriginal(Editor& editor, UiState& ui) {
  finishEdits(editor, ui);
  const Level& level = editor.session.level();
  const auto* file = std::get_if<FileShape>(&level.original.shape);
  browseFiles(ui.browser, FilePurpose::openMesh, file ? modelPath(*file, editor.session.path()) : fs::path());
}

void chooseMirror(Editor& editor, UiState& ui) {
  finishEdits(editor, ui);
  const auto files = surfaceFilesOf(editor.session.level(), editor.session.path());
  browseFiles(ui.browser, FilePurpose::openMirror, files.empty() ? fs::path() : files.front());
}

void importOriginal(Editor& editor, const fs::path& mesh, std::optional<ModelUp> up) {
  editor.session.finishChange();
  MeshImport import{mesh,
                    meshNameFor(mesh, editor.session.path()),
                    editor.session.path(),
                    originalBox(editor),
                    editor.session.isThesisScene() && !editor.session.canUndo(),
                    up};
  editor.job.start(editor.session, trFormat("Reading {}", mesh.filename().string()),
                   [import = std::move(import)](const Level& level, const Progress& progress) {
                     return importMesh(import, level, progress);
                   });
}

void acceptFiles(const std::vector<fs::path>& files, Editor& editor, UiState& ui) {
  for (const fs::path& file : files) {
    if (lowerEnding(file) == ".json") {
      ui.requests.open = file;
      return;
    }
    if (isModelFile(file) && foreignFormatOf(file).empty())
      return ui.meshQuestion ? giveMesh(file, editor, ui) : importOriginal(editor, file);
  }
  if (files.empty()) return;
  std::string text = trFormat(
      "{}: expected a mesh (.obj, .stl, .ply), which takes the "
      "original's place, or a level (.json), which is opened.",
      files.front().filename().string());
  if (const std::string other = foreignFormatOf(files.front()); !other.empty()) text += " " + other + ".";
  ui.notice = Notice{"This cannot be used here", text};
}

void rememberLevel(UiState& ui, const fs::path& path) {
  if (path.empty() || isInstalledLevel(path)) return;
  std::error_code failure;
  fs::path whole = fs::absolute(path, failure).lexically_normal();
  if (failure) return;
  auto& levels = ui.recentLevels;
  levels.erase(std::remove(levels.begin(), levels.end(), whole), levels.end());
  levels.insert(levels.begin(), whole);
  if (levels.size() > maxRecentLevels) levels.resize(maxRecentLevels);
  rememberFolder(ui.browser, whole.parent_path());
}

std::vector<std::string> filesBeingWritten(const Editor& editor, const UiState& ui) {
  std::vector<std::string> files;
  if (editor.saving.busy()) files.push_back(editor.saving.path().string());
  if (ui.exporting.writing) files.push_back(ui.exporting.request.path.string());
  if (!ui.render.saving.empty()) files.push_back(ui.render.saving);
  if (ui.shot.running) files.push_back(ui.shot.file.empty() ? tr("The picture of the window") : ui.shot.file);
  return files;
}

void giveUpQuitting(UiState& ui, const std::string& problem) {
  if (!ui.finish) return;
  ui.finish.reset();
  ui.notice = Notice{"The file could not be written", problem};
}

void settleRequests(Editor& editor, UiState& ui) {
  serveBrowser(editor, ui);
  settleSave(editor, ui, 0);
  saveWhatWaits(editor, ui);
  if (auto wish = takeWish(ui.requests)) {
    endViewDrag(editor, ui.mouse, false);  // it would go on in the next level
    editor.session.cancelChange();
    letGoOfWidgets();
    std::error_code ignored;
    const bool again = wish->next == UnsavedQuestion::Next::open &&
                       fs::equivalent(wish->path, editor.session.path(), ignored);
    const bool quits = wish->next == UnsavedQuestion::Next::quit;
    // An installed level is found again as it was left.
    const bool lost = editor.session.modified() && (again || quits || !editor.session.isInstalled());
    if (lost || (quits && !editor.leftLevels.empty())) {
      ui.unsaved = std::move(wish);
    } else {
      grant(*wish, ui);
    }
  }
  if (ui.unsaved && ui.unsaved->answer != UnsavedQuestion::Answer::none && !ui.browser.open &&
      !editor.saving.busy()) {
    const UnsavedQuestion wish = *std::exchange(ui.unsaved, std::nullopt);
    const bool drop = wish.answer == UnsavedQuestion::Answer::drop;
    // Still modified: the browser was closed without a name, and so nothing happens.
    if (drop || !editor.session.modified()) grant(wish, ui);
  }
  settleFinish(editor, ui);
}

}  // namespace anamorph
