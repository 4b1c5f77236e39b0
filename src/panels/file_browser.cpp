#include "panels/file_browser.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "base/language.h"
#include "base/same_file.h"
#include "exports/export_formats.h"
#include "panels/browser_places.h"
#include "panels/browser_steps.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

bool hasEnding(const FilePurpose& purpose, const std::string& name) {
  const std::string ending = lowerEnding(name);
  return std::any_of(purpose.endings.begin(), purpose.endings.end(),
                     [&](const char* known) { return ending == known; });
}

void select(FileBrowser& b, const std::string& name) {
  for (std::size_t i = 0; i < b.shown.size(); ++i) {
    if (b.listing.entries[static_cast<std::size_t>(b.shown[i])].name == name)
      b.selected = static_cast<int>(i);
  }
  b.bringIntoView = true;
}

const FolderEntry* selectedEntry(const FileBrowser& b) {
  if (b.selected < 0 || b.selected >= static_cast<int>(b.shown.size())) return nullptr;
  return &b.listing.entries[static_cast<std::size_t>(b.shown[static_cast<std::size_t>(b.selected)])];
}

void choose(FileBrowser& b, const fs::path& path) {
  rememberFolder(b, path.parent_path());
  b.chosen = {b.purpose, path};
  b.open = false;
}

void chooseToOpen(FileBrowser& b, const fs::path& path) {
  std::error_code ignored;
  if (fs::exists(path, ignored)) return choose(b, path);
  b.problem = fmt::format(fmt::runtime(tr("{}: there is no such file")), path.string());
}

// "x.3mf" asks for a kind of file; "my level v1.2" is a name.
bool meansEnding(const fs::path& path) {
  const std::string ending = lowerEnding(path);
  return std::any_of(ending.begin(), ending.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

void chooseToSave(FileBrowser& b, fs::path path) {
  if (!hasEnding(b.purpose, path.filename().string())) {
    if (meansEnding(path)) {
      b.problem = wrongEnding(path.filename(), b.purpose.endings);
      return;
    }
    path += b.ending;
  }
  if (!isFolder(path.parent_path())) {
    b.problem = fmt::format(fmt::runtime(tr("{}: there is no such folder")), path.parent_path().string());
    return;
  }
  if (findSameFile(path, b.kept)) {
    b.problem =
        fmt::format(fmt::runtime(tr("{}: the open level is read from this file; choose another name")),
                    path.filename().string());
    return;
  }
  std::error_code ignored;
  if (fs::exists(path, ignored)) {
    b.replace = path;
  } else {
    choose(b, path);
  }
}

void goUp(FileBrowser& b) {
  if (b.folder.has_relative_path()) enterFolder(b, b.folder.parent_path());
}

void makeFolder(FileBrowser& b) {
  std::error_code failure;
  const fs::path folder = pathOf(b, b.text);
  if (b.text.empty()) return;
  fs::create_directory(folder, failure);
  if (failure) {
    b.problem = folder.string() + ": " + failure.message();
    return;
  }
  b.namingFolder = false;
  setBrowserText(b, b.textBefore);
  enterFolder(b, folder);
}

}  // namespace

bool isPath(const std::string& text) {
  return text.find('/') != std::string::npos || text.starts_with("~");
}

fs::path pathOf(const FileBrowser& b, const std::string& text) {
  if (text.starts_with("~")) return homeFolder() / fs::path(text.substr(1)).relative_path();
  return b.folder / text;
}

bool isFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

void setBrowserText(FileBrowser& b, const std::string& text) {
  b.text = text;
  b.proposed = !text.empty();
  ++b.fieldNumber;
  b.takeFocus = true;
}

// The entries that are to be seen.
void chooseShown(FileBrowser& b) {
  const FilePurpose& purpose = b.purpose;
  const std::string filter = purpose.saves || b.namingFolder || isPath(b.text) ? "" : lowerCase(b.text);
  const std::string wanted = fmt::format("{}{} {}", b.showHidden, b.showAll, filter);
  if (wanted == b.shownFor) return;
  b.shownFor = wanted;
  b.shown.clear();
  for (std::size_t i = 0; i < b.listing.entries.size(); ++i) {
    const FolderEntry& entry = b.listing.entries[i];
    if (!b.showHidden && entry.name.starts_with(".")) continue;
    if (!entry.isFolder && !b.showAll && !hasEnding(purpose, entry.name)) continue;
    if (!filter.empty() && lowerCase(entry.name).find(filter) == std::string::npos) continue;
    b.shown.push_back(static_cast<int>(i));
  }
  b.selected = filter.empty() || b.shown.empty() ? -1 : 0;
  b.bringIntoView = true;
}

// Where it cannot be listed, everything stays as it was.
void enterFolder(FileBrowser& b, const fs::path& path) {
  std::error_code ignored;
  fs::path folder = fs::absolute(path, ignored).lexically_normal();
  if (!folder.has_filename() && folder.has_relative_path()) folder = folder.parent_path();  // a / at its end
  if (!b.root.empty() && !isBelow(folder, b.root)) folder = b.root;
  FolderListing listing = listFolder(folder);
  if (!listing.problem.empty()) {
    b.problem = folder.string() + ": " + listing.problem;
    return;
  }
  const fs::path before = b.folder;
  b.folder = folder;
  b.listing = std::move(listing);
  b.problem.clear();
  b.replace.clear();
  if (!b.purpose.saves) setBrowserText(b, "");
  b.takeFocus = true;
  b.shownFor.clear();
  b.selected = -1;
  chooseShown(b);
  if (before.parent_path() == folder) select(b, before.filename().string());  // gone up: where from
}

// As soon as a folder and a / have been typed.
void enterTypedFolder(FileBrowser& b) {
  const std::size_t slash = b.text.rfind('/');
  if (slash == std::string::npos) return;
  const fs::path folder = pathOf(b, b.text.substr(0, slash + 1));
  if (!isFolder(folder)) return;
  const std::string rest = b.text.substr(slash + 1);
  enterFolder(b, folder);
  if (!b.problem.empty()) return;
  setBrowserText(b, rest);
  b.proposed = false;
  b.caretToEnd = true;
}

// Enter, or the button.
void acceptChoice(FileBrowser& b) {
  b.problem.clear();
  if (!b.replace.empty()) return choose(b, b.replace);
  if (b.namingFolder) return makeFolder(b);
  const bool saves = b.purpose.saves;
  if (isPath(b.text)) {
    const fs::path path = pathOf(b, b.text);
    if (isFolder(path)) {
      setBrowserText(b, "");
      return enterFolder(b, path);
    }
    return saves ? chooseToSave(b, path) : chooseToOpen(b, path);
  }
  const FolderEntry* entry = selectedEntry(b);
  if (entry && entry->isFolder) return enterFolder(b, b.folder / entry->name);
  if (saves && b.text.empty()) {
    b.problem = tr("Type a name for the file.");
  } else if (saves) {
    chooseToSave(b, b.folder / b.text);
  } else if (entry) {
    choose(b, b.folder / entry->name);
  } else if (!b.text.empty()) {
    chooseToOpen(b, b.folder / b.text);
  }
}

void leaveStep(FileBrowser& b) {
  b.problem.clear();
  if (!b.replace.empty()) {
    b.replace.clear();
    b.takeFocus = true;
  } else if (b.namingFolder) {
    b.namingFolder = false;
    setBrowserText(b, b.textBefore);
  } else {
    b.open = false;
  }
}

void selectRow(FileBrowser& b, int row) {
  b.selected = std::clamp(row, 0, std::max(0, static_cast<int>(b.shown.size()) - 1));
  if (b.shown.empty()) b.selected = -1;
  b.bringIntoView = true;
  const FolderEntry* entry = selectedEntry(b);
  if (entry && !entry->isFolder && b.purpose.saves) setBrowserText(b, entry->name);
}

void handleBrowserKeys(FileBrowser& b, const DialogKeys& typed, bool fieldWasEmpty, int rowsInSight) {
  for (const auto& [key, repeated] : typed) {
    if (!b.open) return;
    if (key == keys::enter || key == keys::padEnter) {
      if (!repeated) acceptChoice(b);
    } else if (key == keys::escape) {
      leaveStep(b);
    } else if (b.replace.empty() && !b.namingFolder) {
      if (key == keys::down) selectRow(b, b.selected + 1);
      if (key == keys::up) selectRow(b, b.selected - 1);
      if (key == keys::pageDown) selectRow(b, b.selected + rowsInSight);
      if (key == keys::pageUp) selectRow(b, b.selected - rowsInSight);
      if (key == keys::backspace && fieldWasEmpty && !repeated) goUp(b);
    }
  }
}

void browseFiles(FileBrowser& b, const FilePurpose& purpose, const fs::path& start) {
  FileBrowser fresh;
  fresh.open = true;
  fresh.purpose = purpose;
  fresh.root = b.root;
  fresh.fieldNumber = b.fieldNumber;
  fresh.recentFolders = std::move(b.recentFolders);
  b = std::move(fresh);
  const bool named = !start.empty() && !isFolder(start) && start.has_filename();
  const std::string name = named ? start.filename().string() : "";
  b.ending =
      hasEnding(purpose, name) ? fs::path(name).extension().string() : std::string(purpose.endings.front());
  std::vector<fs::path> candidates{named ? (start.has_parent_path() ? start.parent_path() : ".") : start};
  candidates.insert(candidates.end(), b.recentFolders.begin(), b.recentFolders.end());
  for (const fs::path& folder : {homeFolder(), fs::path("/")}) candidates.push_back(folder);
  for (const fs::path& folder : candidates) {
    if (b.folder.empty() && isFolder(folder)) enterFolder(b, folder);
  }
  b.problem.clear();
  if (purpose.saves) setBrowserText(b, name);
  if (named) select(b, name);
}

std::optional<fs::path> takeChosenFile(FileBrowser& b, const FilePurpose& purpose) {
  auto& chosen = b.chosen;
  if (!chosen || chosen->first != purpose) return std::nullopt;
  fs::path path = std::move(chosen->second);
  chosen.reset();
  return path;
}

std::optional<fs::path> awaitChosenFile(FileBrowser& b, const FilePurpose& purpose, bool& waiting) {
  if (!waiting) return std::nullopt;
  auto path = takeChosenFile(b, purpose);
  waiting = !path && b.open;
  return path;
}

}  // namespace anamorph
