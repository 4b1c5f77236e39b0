// Take it home: one function that makes any of the files a level gives, for the command line and the window alike.
//
// Always of the finished, refined level. A file is replaced atomically; cancelled, nothing is written.
#pragma once

#include <cstddef>
#include <optional>

#include "base/progress.h"
#include "exports/export_request.h"
#include "exports/print_check.h"
#include "pipeline/level_result.h"

namespace anamorph {

/// Makes the file of a level that has a sculpture. Throws Error. Nothing, and no file, when cancelled.
std::optional<ExportSummary> exportLevel(const LevelResult& finished, const ExportRequest& request,
                                         int threads = 1, const Progress& progress = {});

/// checkPrint for the sculpture as it would be printed, without a base plate: that is sound by itself, and
/// overlaps the sculpture on purpose. Of the request its scale and the smallest width count. Nothing when cancelled.
std::optional<PrintCheck> checkSculpture(const LevelResult& finished, const ExportRequest& request,
                                         int threads = 1, const Progress& progress = {});

/// What of the original is not in the sculpture, for findPrintProblems.
LeftOut leftOutOf(const LevelResult& finished);

}  // namespace anamorph
