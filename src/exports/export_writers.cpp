#include "exports/export_writers.h"

#include <utility>

#include <fmt/format.h>

#include "base/count.h"
#include "base/error.h"
#include "base/file.h"
#include "base/folder.h"
#include "base/language.h"
#include "exports/arrangement.h"
#include "exports/match_report_files.h"
#include "exports/page_file.h"
#include "exports/print_repairs.h"
#include "exports/printable.h"
#include "exports/ray_file.h"
#include "exports/viewing_sheet.h"
#include "geometry/mesh_files.h"
#include "level/freeze.h"
#include "raytrace/png.h"

namespace anamorph {
namespace {

constexpr double hiddenWorthSaying = 0.005;  // share of the pixels

// What is set up by hand is set up to be right: a frozen sculpture with the mirror and the eye that it was made for.
LevelResult asMade(LevelResult finished) {
  finished.level = asMade(std::move(finished.level));
  return finished;
}

std::vector<std::string> findPlateWarnings(const LevelResult& finished, const Arrangement& arrangement) {
  std::vector<std::string> warnings;
  if (!arrangement.plate) return warnings;
  const double hidden = fractionHiddenByPlate(finished, arrangement);
  if (hidden > hiddenWorthSaying) {
    warnings.push_back(
        trFormat("the base plate hides {:.1f} % of the reflection: it stands between the "
                 "eye and the mirror, or between the mirror and the sculpture",
                 100 * hidden));
  }
  const double below = arrangement.table - arrangement.plate->lowerFace;
  if (below > 1e-9 * arrangement.plate->thickness) {
    warnings.push_back(
        trFormat("the base plate's lower face is {:.1f} mm below the "
                 "table: raise the mirror and the eye by as much",
                 below));
  }
  return warnings;
}

// Sheet and report are of use without a base plate that cannot be; why it is not there is said.
Arrangement arrangeIfPossible(const LevelResult& finished, const ExportRequest& request,
                              std::vector<std::string>& warnings) {
  try {
    return makeArrangement(finished, request.millimetresPerUnit, request.basePlate);
  } catch (const Error& error) {
    if (!request.basePlate) throw;
    warnings.push_back(trFormat("made without the base plate: {}", error.message));
    return makeArrangement(finished, request.millimetresPerUnit, {});
  }
}

std::pair<int, int> sizeOf(const ExportRequest& request, const PixelGrid& grid) {
  return request.exactSize ? *request.exactSize : pictureSize(grid, request.size);
}

}  // namespace

std::optional<ExportSummary> writeSculpture(const LevelResult& shown, const ExportRequest& request,
                                            int /*threads*/, const Progress& progress) {
  const LevelResult finished = asMade(shown);
  Arrangement arrangement = makeArrangement(finished, request.millimetresPerUnit, request.basePlate);
  ExportSummary summary{{}, findPlateWarnings(finished, arrangement)};
  PreparedPrint print =
      prepareForPrint(std::move(arrangement.sculpture), finished.level.sculpture.tolerancePixels > 0);
  for (std::string& note : print.notes) summary.warnings.push_back(std::move(note));
  Mesh& mesh = print.mesh;
  if (arrangement.plate) appendMesh(mesh, arrangement.plate->mesh);
  const Vector size = boundingBox(mesh.positions).size();
  summary.description = countOf(mesh.positions.size(), "vertex", "vertices") + ", " +
                        countOf(mesh.triangles.size(), "triangle", "triangles") +
                        shownFormat(", {:.1f} x {:.1f} x {:.1f} mm", size.x, size.y, size.z);
  if (arrangement.plate) summary.description += tr(" with its base plate");
  if (!progress.update(0.5)) return std::nullopt;
  MeshFileOptions file;
  file.comment = fmt::format("sculpture for the {} {} in millimetres, {:g} per scene unit, made by Anamorph",
                             shapeName(finished.level.optic.shape()), surfaceName(finished.level.optic),
                             request.millimetresPerUnit);
  if (progress.cancelled()) return std::nullopt;
  for (std::string& lost : saveMesh(request.path, mesh, file)) summary.warnings.push_back(std::move(lost));
  return summary;
}

std::optional<ExportSummary> writeViewingSheet(const LevelResult& shown, const ExportRequest& request,
                                               int /*threads*/, const Progress& progress) {
  const LevelResult finished = asMade(shown);
  std::vector<std::string> warnings;
  const Arrangement arrangement = arrangeIfPossible(finished, request, warnings);
  if (!progress.update(0.3)) return std::nullopt;
  const ViewingSheet sheet = makeViewingSheet(finished, arrangement, request.paper, request.sheetScale);
  if (!progress.update(0.8)) return std::nullopt;
  const bool pdf = lowerEnding(request.path) == ".pdf";
  const std::string page = encodePage(sheet.page, pdf ? PageFormat::pdf : PageFormat::svg);
  if (progress.cancelled()) return std::nullopt;
  ExportSummary summary{trFormat("viewing sheet, {} at 1:{:g}", paperName(request.paper), sheet.scale),
                        findPlateWarnings(finished, arrangement)};
  summary.warnings.insert(summary.warnings.begin(), warnings.begin(), warnings.end());
  if (shown.level.sculpture.frozen)
    summary.warnings.emplace_back(
        tr("the sheet has mirror and eye where they were when the sculpture was frozen"));
  for (std::string& lost : writeFile(request.path, page)) summary.warnings.push_back(std::move(lost));
  return summary;
}

std::optional<ExportSummary> writeRays(const LevelResult& finished, const ExportRequest& request,
                                       int /*threads*/, const Progress& progress) {
  const bool ofVertices = request.vertexRays.has_value();
  const auto text =
      ofVertices ? makeVertexRayObj(finished, *request.vertexRays, request.millimetresPerUnit, progress)
                 : makePixelRayObj(finished, request.millimetresPerUnit, progress);
  if (!text || progress.cancelled()) return std::nullopt;
  return ExportSummary{tr(ofVertices ? "vertex rays, as lines" : "rays of the pixel grid, as lines"),
                       writeFile(request.path, *text)};
}

std::optional<ExportSummary> writeMatchReport(const LevelResult& finished, const ExportRequest& request,
                                              int threads, const Progress& progress) {
  const auto [width, height] = sizeOf(request, finished.level.grid);
  std::shared_ptr<const Bvh> plate;
  std::vector<std::string> warnings;
  if (request.basePlate) plate = plateInScene(arrangeIfPossible(asMade(finished), request, warnings));
  const Match match = matchLevel(finished, width, height, threads, partOf(progress, 0, 0.4), plate);
  if (progress.cancelled()) return std::nullopt;
  const std::string description = trFormat("match report, {}", tr(matchGradeName(gradeOf(match.report))));
  const auto written = [&](std::vector<std::string> lost) {
    warnings.insert(warnings.end(), lost.begin(), lost.end());
    return ExportSummary{description, warnings};
  };
  if (lowerEnding(request.path) == ".json") {
    const StatusCounts& counts = finished.sculpture.sculpture->originalStatus;
    return written(writeFile(request.path, formatJson(matchJson(match.report, counts))));
  }
  const ImageRequest image = makeImageRequest(finished.level, width, height, threads);
  auto reflection =
      makePicture(finished, PictureKind::reflection, image, nullptr, partOf(progress, 0.4, 0.8));
  auto original = makePicture(finished, PictureKind::original, image, nullptr, partOf(progress, 0.8, 1));
  if (!reflection || !original) return std::nullopt;
  Image difference = markDifferences(*original, match);
  const std::string page = makeMatchPage(
      finished, match.report, {std::move(*reflection), std::move(*original), std::move(difference)});
  if (progress.cancelled()) return std::nullopt;
  return written(writeFile(request.path, page));
}

std::optional<ExportSummary> writePicture(const LevelResult& finished, const ExportRequest& request,
                                          int threads, const Progress& progress) {
  const auto [width, height] = sizeOf(request, finished.level.grid);
  Match match;
  const bool compares = request.picture == PictureKind::difference;
  if (compares) match = matchLevel(finished, width, height, threads, partOf(progress, 0, 0.4));
  if (progress.cancelled()) return std::nullopt;
  const auto image =
      makePicture(finished, request.picture, makeImageRequest(finished.level, width, height, threads), &match,
                  partOf(progress, compares ? 0.4 : 0, 1));
  if (!image) return std::nullopt;
  return ExportSummary{trFormat("{} x {} pixels", width, height), savePng(request.path, *image)};
}

}  // namespace anamorph
