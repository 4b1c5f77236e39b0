#include "panels/export_entries.h"

namespace anamorph {

const std::vector<ExportEntry>& exportEntries() {
  static const std::vector<ExportEntry> entries = [] {
    std::vector<ExportEntry> all;
    for (const ExportFormat& format : exportFormats()) {
      all.push_back({format.name, format.help, format.fileName, FilePurpose::toSave(format), &format});
    }
    all.push_back(
        {"Screenshot", "The window as it is, as PNG.", "window.png", FilePurpose::saveImage, nullptr});
    return all;
  }();
  return entries;
}

}  // namespace anamorph
