// The kinds of files that a level can be taken home as, one table. The export window, the command line, the file
// browser and README's table of exports are made of it: another export is an enumerator of ExportKind, a row here and
// its writer.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "exports/export_request.h"
#include "pipeline/level_result.h"

namespace anamorph {

/// What can be asked of an export. The window has rows for each, drawn in the order of a format's list.
enum class ExportOption {
  millimetres,   ///< per scene unit
  basePlate,     ///< under the sculpture, or none
  page,          ///< paper and scale of a printed page
  raysOf,        ///< vertices or pixels
  picture,       ///< which one
  pictureSize,   ///< pixels of its longer side
  comparedSize,  ///< likewise, of pictures that are compared
  printCheck,    ///< whether it can be printed
};

struct ExportFormat {
  ExportKind kind = ExportKind::sculpture;
  const char* name = "";             ///< as a title: "Viewing sheet"
  const char* help = "";             ///< what it is for, and as what files
  const char* title = "";            ///< of the window that chooses its file
  const char* fileName = "";         ///< the file that is proposed
  std::vector<const char*> endings;  ///< in small letters
  std::vector<ExportOption> options;
  /// Where its endings are another format's: the command's option that means this.
  const char* askedBy = nullptr;
  std::optional<ExportSummary> (*write)(const LevelResult& finished, const ExportRequest& request,
                                        int threads, const Progress& progress) = nullptr;

  bool has(ExportOption option) const;
};

/// All of them, in the order of ExportKind.
const std::vector<ExportFormat>& exportFormats();
const ExportFormat& formatOf(ExportKind kind);

/// Whether a file's name ends as the format's do, in small or capital letters.
bool hasEnding(const ExportFormat& format, const std::filesystem::path& path);

/// The kind that a file's ending asks for; .obj is a sculpture. Nothing for an unknown ending.
std::optional<ExportKind> findExportKind(const std::filesystem::path& path);

/// What is said of a name with another ending: "x.3mf: expected an output file that ends in .obj, .stl or .ply".
std::string wrongEnding(const std::filesystem::path& file, const std::vector<const char*>& endings);

/// The endings of a kind, for messages: ".obj, .stl or .ply".
std::string exportEndings(ExportKind kind);

}  // namespace anamorph
