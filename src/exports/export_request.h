// Take it home: one function that makes any of the files a level gives, for the command line and the window
// alike.
//
//   sculpture     .obj .stl .ply   in millimetres, with a base plate on request
//   viewingSheet  .pdf .svg        one page to set mirror, sculpture and eye up by
//   rays          .obj             vertex rays or the pixel grid's rays, as lines
//   matchReport   .html .json      how well the reflection agrees with the original
//   picture       .png             what the RT camera sees
//
// Always of the finished, refined level. A file is replaced atomically; cancelled, nothing is written.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "exports/arrangement.h"
#include "exports/print_check.h"
#include "exports/viewing_sheet.h"

namespace anamorph {

enum class ExportKind { sculpture, viewingSheet, rays, matchReport, picture };

struct ExportRequest {
  ExportKind kind = ExportKind::sculpture;
  std::filesystem::path path;
  double millimetresPerUnit = 10;              ///< sculpture, sheet, rays
  std::optional<BasePlateSettings> basePlate;  ///< sculpture, sheet
  Paper paper = Paper::a4;                     ///< sheet
  std::optional<double> sheetScale;            ///< sheet: 1 : this; without: what fits
  std::optional<int> vertexRays = 200;         ///< rays: of so many vertices; nothing: the pixel grid's
  PictureKind picture = PictureKind::reflection;
  int size = 512;  ///< picture, match report: pixels of the longer side
};

/// What was written, for a message.
struct ExportSummary {
  std::string description;            ///< "6146 vertices, 12288 triangles, 78.1 x 22.0 x 13.3 mm"
  std::vector<std::string> warnings;  ///< whole sentences
};

/// The kind that a file's ending asks for, in small or capital letters; .obj is a sculpture. Nothing for an
/// unknown ending.
std::optional<ExportKind> findExportKind(const std::filesystem::path& path);

/// The endings of a kind, for messages and file dialogs: ".obj, .stl or .ply".
const char* exportEndings(ExportKind kind);

/// Makes the file of a level that has a sculpture. Throws Error. Nothing, and no file, when cancelled.
std::optional<ExportSummary> exportLevel(const LevelResult& finished, const ExportRequest& request,
                                         int threads = 1, const Progress& progress = {});

/// checkPrint for the sculpture as it would be printed, without a base plate: that is sound by itself, and
/// overlaps the sculpture on purpose. Nothing when cancelled.
std::optional<PrintCheck> checkSculpture(const LevelResult& finished, double millimetresPerUnit,
                                         int threads = 1, const Progress& progress = {});

/// How many vertices of the original are not in the sculpture, for findPrintProblems.
std::size_t countNotMapped(const LevelResult& finished);

}  // namespace anamorph
