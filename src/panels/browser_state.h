// What the file browser remembers between frames. Plain data.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/folder.h"
#include "panels/file_purpose.h"

namespace anamorph {

constexpr std::size_t maxRecentFolders = 6;

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
  std::vector<std::filesystem::path>
      kept;                    ///< files that the open level is read from: nothing is saved over them
  std::filesystem::path root;  ///< nothing above it is shown; empty: no limit
  std::optional<std::pair<FilePurpose, std::filesystem::path>> chosen;
  std::vector<std::filesystem::path> recentFolders;  ///< newest first; kept between runs
};

}  // namespace anamorph
