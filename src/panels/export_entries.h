// What the export window offers: every format of the level's exports, and a picture of the window itself, which nothing
// else can take.
#pragma once

#include <vector>

#include "exports/export_formats.h"
#include "panels/file_purpose.h"

namespace anamorph {

struct ExportEntry {
  const char* name;  ///< English, like help
  const char* help;
  const char* fileName;  ///< that is proposed
  FilePurpose purpose;
  const ExportFormat* format;  ///< null: the picture of the window
};

const std::vector<ExportEntry>& exportEntries();

}  // namespace anamorph
