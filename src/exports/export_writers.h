// What the rows of export_formats.h are written by: each makes the file of a request and says what it is. Nothing, and
// no file, when cancelled; throws Error.
#pragma once

#include <optional>

#include "base/progress.h"
#include "exports/export_request.h"
#include "pipeline/level_result.h"

namespace anamorph {

std::optional<ExportSummary> writeSculpture(const LevelResult& finished, const ExportRequest& request,
                                            int threads, const Progress& progress);
std::optional<ExportSummary> writeViewingSheet(const LevelResult& finished, const ExportRequest& request,
                                               int threads, const Progress& progress);
std::optional<ExportSummary> writeRays(const LevelResult& finished, const ExportRequest& request, int threads,
                                       const Progress& progress);
std::optional<ExportSummary> writeMatchReport(const LevelResult& finished, const ExportRequest& request,
                                              int threads, const Progress& progress);
std::optional<ExportSummary> writePicture(const LevelResult& finished, const ExportRequest& request,
                                          int threads, const Progress& progress);

}  // namespace anamorph
