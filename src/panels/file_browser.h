// Choosing a file, to open or to save: a browser of the program's own, the same on every system and usable by
// keys alone. Plain data between frames:
//
//   browseFiles(ui, FilePurpose::saveImage, "folder/or/file.png");      ... frames, until ...
//   if (auto path = takeChosenFile(ui, FilePurpose::saveImage)) ...
//
// Typing filters (or is the name to save as); arrows and Enter choose, Backspace in an empty field goes up,
// Esc closes. What has a / or ~ in it is a path. It only chooses: reading and writing are the caller's.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/folder.h"

namespace anamorph {

struct ExportFormat;
struct UiState;

/// What a file is chosen for.
struct FilePurpose {
  const char* title;  ///< of the browser, in English; no two purposes have the same
  const char* button;
  bool saves;  ///< a file that is there is asked about, and a name without an ending gets one
  std::vector<const char*> endings;  ///< of the files that are shown

  static const FilePurpose openLevel, saveLevel, openMesh, saveImage;
  static FilePurpose toSave(const ExportFormat& format);

  bool operator==(const FilePurpose& other) const;
};

struct FileBrowser {
  bool open = false;
  FilePurpose purpose = FilePurpose::openLevel;
  std::filesystem::path folder;
  FolderListing listing;       ///< of the folder, read once
  std::string text;            ///< that is typed: a filter, or the name to save as
  int fieldNumber = 0;         ///< grows when the text is set by something else than typing
  bool takeFocus = false;      ///< the field gets the keyboard in the next frame
  bool proposed = false;       ///< the text is a proposal, that typing replaces
  bool caretToEnd = false;     ///< the field goes on behind its text
  std::string ending;          ///< put behind a name without one
  int selected = -1;           ///< a row of those shown; -1: none
  bool bringIntoView = false;  ///< the selected row
  std::vector<int> shown;      ///< entries of the listing
  std::string shownFor;        ///< what they were chosen by
  bool showHidden = false;     ///< names that begin with a dot
  bool showAll = false;        ///< files of other kinds, too
  bool namingFolder = false;   ///< `text` is the name of a new folder, and this the text before:
  std::string textBefore;
  std::filesystem::path replace;  ///< a file that is there: may it be replaced? Empty: nothing is asked
  std::string problem;            ///< what did not work, for a person
  std::filesystem::path root;     ///< nothing above it is shown; empty: no limit
  std::optional<std::pair<FilePurpose, std::filesystem::path>> chosen;
};

/// Opens the browser. `start`: a folder, or a file whose folder is shown and, to save, whose name is
/// proposed; empty: the last folder, or home.
void browseFiles(UiState& ui, const FilePurpose& purpose, const std::filesystem::path& start = {});

/// The file that was chosen for this, once.
std::optional<std::filesystem::path> takeChosenFile(UiState& ui, const FilePurpose& purpose);

/// For a window that opened the browser and waits: the same, once; `waiting` ends with the file, and when the
/// browser was closed without one.
std::optional<std::filesystem::path> awaitChosenFile(UiState& ui, const FilePurpose& purpose, bool& waiting);

void drawFileBrowser(UiState& ui);

}  // namespace anamorph
