// Take it home: the sculpture for a printer, the sheet to set it up by, rays, reports and pictures. The
// window asks; the export job makes the file from the settled level.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "exports/export_request.h"
#include "panels/browser_state.h"
#include "panels/look.h"
#include "panels/requests.h"

namespace anamorph {

struct ExportDialog {
  bool open = false;
  int kind = 0;  ///< which one of exportEntries() (export_entries.h)
  ExportRequest request;
  ShotRequest shot;
  bool saveAsked = false;        ///< by the key Enter
  std::filesystem::path folder;  ///< of the last export; empty: none yet
  bool choosing = false;         ///< the file browser is open for it
  bool running = false;
  bool writing = false;  ///< what runs makes a file, which is not there before it has ended
  double fraction = 0;
  std::string message;                                    ///< what came of the last one
  std::vector<std::string> lines;                         ///< and what else is to be said about it
  std::vector<std::pair<std::string, std::string>> rows;  ///< figures, in two columns

  /// In place of what was said before.
  void say(std::string text, std::vector<std::string> more = {},
           std::vector<std::pair<std::string, std::string>> figures = {}) {
    message = std::move(text);
    lines = std::move(more);
    rows = std::move(figures);
  }
};

/// The window by keys alone: the kind, and on to the file. Returns whether the key meant something.
bool exportKey(ExportDialog& dialog, int key);

/// `level`: the file whose name the export's is made of, may be empty.
void drawExportWindow(ExportDialog& dialog, const std::filesystem::path& level, FileBrowser& browser,
                      UiRequests& requests, const Look& look);

}  // namespace anamorph
