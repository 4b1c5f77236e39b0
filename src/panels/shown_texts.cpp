#include "panels/shown_texts.h"

#include <variant>

namespace anamorph {
namespace {

using Visit = std::function<void(std::string_view)>;

void visitLevel(const Editor& editor, const Visit& visit) {
  visit(editor.session.path().native());
  const OriginalShape& shape = editor.session.level().original.shape;
  if (const auto* mesh = std::get_if<FileShape>(&shape)) visit(mesh->path);
}

void visitResult(const LevelResult& result, const Visit& visit) {
  if (result.problem) visit(*result.problem);
  for (const auto* warnings : {&result.warnings, &result.shapeWarnings}) {
    for (const std::string& warning : *warnings) visit(warning);
  }
}

void visitFiles(const UiState& ui, const Visit& visit) {
  const FileBrowser& browser = ui.browser;
  visit(browser.folder.native());
  visit(browser.text);
  visit(browser.problem);
  if (browser.open) {
    for (const FolderEntry& entry : browser.listing.entries) visit(entry.name);
  }
  for (const auto* paths : {&browser.recentFolders, &ui.recentLevels}) {
    for (const std::filesystem::path& path : *paths) visit(path.native());
  }
  visit(ui.exporting.message);
  for (const std::string& line : ui.exporting.lines) visit(line);
  visit(ui.render.message);
}

void visitDialogs(const UiState& ui, const Visit& visit) {
  if (ui.notice) visit(ui.notice->text);
  if (ui.unsaved) visit(ui.unsaved->path.native());
  if (ui.meshQuestion) visit(ui.meshQuestion->mesh.native());
  for (const RecoveryEntry& entry : ui.recovery.entries) {
    visit(entry.level.native());
    visit(entry.title);
    visit(entry.problem);
  }
}

}  // namespace

void forEachTextOf(const LevelText& level, const Visit& visit) {
  for (const std::string* text : {&level.title, &level.description, &level.lesson}) visit(*text);
}

void forEachShownText(const Editor& editor, const UiState& ui, const Visit& visit) {
  visitLevel(editor, visit);
  visitResult(editor.updater.result(), visit);
  visit(editor.status.text());
  if (editor.opening.busy()) visit(editor.opening.path().native());
  if (editor.saving.busy()) visit(editor.saving.path().native());
  if (editor.job.busy()) visit(editor.job.name());
  for (const auto& [path, left] : editor.leftLevels) visit(left.text->title);
  for (const LevelEntry& entry : ui.levels) {
    visit(entry.title);
    visit(entry.lesson.badge.title);
  }
  for (const LanguageChoice& language : ui.languages) visit(language.name);
  visitFiles(ui, visit);
  visitDialogs(ui, visit);
}

}  // namespace anamorph
