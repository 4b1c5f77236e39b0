// What is asked of an export, and what came of it: plain data. The kinds there are stand in export_formats.h, the file
// is made by export_level.h.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exports/base_plate.h"
#include "exports/page.h"
#include "pipeline/picture.h"

namespace anamorph {

/// A row of export_formats.h each.
enum class ExportKind { sculpture, viewingSheet, rays, matchReport, picture };

struct ExportRequest {
  ExportKind kind = ExportKind::sculpture;
  std::filesystem::path path;
  double millimetresPerUnit = 10;  ///< sculpture, sheet, rays, base plate
  double smallestWidth = 0.8;      ///< print check: of a wall, in millimetres; 0.8 is two usual lines
  std::optional<BasePlateSettings> basePlate;  ///< sculpture, sheet; match report: what it hides
  Paper paper = Paper::a4;                     ///< sheet
  std::optional<double> sheetScale;            ///< sheet: 1 : this; without: what fits
  std::optional<int> vertexRays = 200;         ///< rays: of so many vertices; nothing: the pixel grid's
  PictureKind picture = PictureKind::reflection;
  int size = 512;  ///< picture, match report: pixels of the longer side
  std::optional<std::pair<int, int>>
      exactSize;  ///< or width and height, whatever the pixel grid's proportions
};

/// What was written, for a message.
struct ExportSummary {
  std::string description;            ///< "6146 vertices, 12288 triangles, 78.1 x 22.0 x 13.3 mm"
  std::vector<std::string> warnings;  ///< whole sentences
};

}  // namespace anamorph
