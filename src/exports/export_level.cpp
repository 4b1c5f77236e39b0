#include "exports/export_level.h"

#include <numeric>
#include <string>

#include "base/check.h"
#include "base/error.h"
#include "exports/export_formats.h"
#include "exports/print_repairs.h"
#include "exports/printable.h"

namespace anamorph {

std::optional<ExportSummary> exportLevel(const LevelResult& finished, const ExportRequest& request,
                                         int threads, const Progress& progress) {
  const ExportFormat& format = formatOf(request.kind);
  // Files of another kind than their ending says would not open.
  if (!hasEnding(format, request.path)) {
    throw Error("expected a file name that ends in " + exportEndings(request.kind), request.path.string());
  }
  CHECK(hasSculpture(finished));
  if (!progress.update(0)) return std::nullopt;
  return format.write(finished, request, threads, progress);
}

std::optional<PrintCheck> checkSculpture(const LevelResult& finished, const ExportRequest& request,
                                         int threads, const Progress& progress) {
  PreparedPrint print =
      prepareForPrint(makePrintable(finished.sculpture.sculpture->mesh, request.millimetresPerUnit),
                      finished.level.sculpture.tolerancePixels > 0);
  auto check = checkPrint(print.mesh, threads, progress, {.smallestWidth = request.smallestWidth});
  if (check) check->notes = std::move(print.notes);
  return check;
}

LeftOut leftOutOf(const LevelResult& finished) {
  const Sculpture& sculpture = *finished.sculpture.sculpture;
  const StatusCounts& counts = sculpture.originalStatus;
  return {std::accumulate(counts.begin() + 1, counts.end(), std::size_t{0}), sculpture.folded.share};
}

}  // namespace anamorph
