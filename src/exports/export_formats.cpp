#include "exports/export_formats.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/check.h"
#include "base/folder.h"
#include "base/language.h"
#include "base/text.h"
#include "exports/export_writers.h"

namespace anamorph {

const std::vector<ExportFormat>& exportFormats() {
  using enum ExportOption;
  static const std::vector<ExportFormat> formats{
      {.kind = ExportKind::sculpture,
       .name = "Sculpture",
       .help = "For a 3D printer: OBJ, STL or PLY, in millimetres.",
       .title = "Export the sculpture",
       .fileName = "sculpture.stl",
       .endings = {".obj", ".stl", ".ply"},
       .options = {millimetres, basePlate, printCheck},
       .write = writeSculpture},
      {.kind = ExportKind::viewingSheet,
       .name = "Viewing sheet",
       .help =
           "One page, PDF or SVG: put mirror and sculpture on their outlines, and your eye where it says.",
       .title = "Export the viewing sheet",
       .fileName = "sheet.pdf",
       .endings = {".pdf", ".svg"},
       .options = {millimetres, basePlate, page},
       .write = writeViewingSheet},
      {.kind = ExportKind::rays,
       .name = "Rays",
       .help = "Lines for a modelling program, as OBJ.",
       .title = "Export the rays",
       .fileName = "rays.obj",
       .endings = {".obj"},
       .options = {millimetres, raysOf},
       .askedBy = "--rays",
       .write = writeRays},
      {.kind = ExportKind::matchReport,
       .name = "Match report",
       .help = "How well the reflection agrees: a page with pictures (HTML), or figures (JSON).",
       .title = "Export the match report",
       .fileName = "match.html",
       .endings = {".html", ".json"},
       .options = {comparedSize},
       .write = writeMatchReport},
      {.kind = ExportKind::picture,
       .name = "Picture",
       .help = "What the RT camera sees, as PNG.",
       .title = "Save the picture",
       .fileName = "picture.png",
       .endings = {".png"},
       .options = {picture, pictureSize},
       .write = writePicture},
  };
  return formats;
}

const ExportFormat& formatOf(ExportKind kind) {
  const ExportFormat& format = exportFormats().at(static_cast<std::size_t>(kind));
  CHECK(format.kind == kind);
  return format;
}

bool ExportFormat::has(ExportOption option) const {
  return std::find(options.begin(), options.end(), option) != options.end();
}

bool hasEnding(const ExportFormat& format, const std::filesystem::path& path) {
  return std::find(format.endings.begin(), format.endings.end(), lowerEnding(path)) != format.endings.end();
}

std::optional<ExportKind> findExportKind(const std::filesystem::path& path) {
  for (const ExportFormat& format : exportFormats()) {
    if (!format.askedBy && hasEnding(format, path)) return format.kind;
  }
  return std::nullopt;
}

std::string wrongEnding(const std::filesystem::path& file, const std::vector<const char*>& endings) {
  return fmt::format(fmt::runtime(tr("{}: expected an output file that ends in {}")), file.string(),
                     alternatives({endings.begin(), endings.end()}, tr("or")));
}

std::string exportEndings(ExportKind kind) {
  const std::vector<const char*>& endings = formatOf(kind).endings;
  return alternatives({endings.begin(), endings.end()});
}

}  // namespace anamorph
