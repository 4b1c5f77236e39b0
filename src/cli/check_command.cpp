// anamorph check: what is wrong with a level, a scene or a mesh, and where.

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/count.h"
#include "base/error.h"
#include "base/file.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/print.h"
#include "cli/report.h"
#include "exports/inside_out.h"
#include "exports/print_repairs.h"
#include "level/json_places.h"
#include "level/lesson_check.h"
#include "level/level_json.h"
#include "level/level_library.h"
#include "pipeline/evaluator.h"
#include "pipeline/original.h"

namespace anamorph {
namespace {

// What is said of a file; faults are thrown, and keep what was found before them.
struct Finding {
  std::string summary;
  std::vector<std::string> warnings;

  void warn(const std::vector<std::string>& more) {
    warnings.insert(warnings.end(), more.begin(), more.end());
  }
};

// What of a surface that can be read will trouble whoever wants to print it, each as far as there is any.
std::vector<std::string> surfaceRemarks(const Mesh& welded, const std::string& file) {
  const Surface surface = measureSurface(welded);
  const SurfaceTopology& topology = surface.topology;
  const std::size_t doubled = findDoubled(welded.triangles).size();
  struct Count {
    std::size_t count;
    const char *one, *many;
  };
  const Count counts[] = {
      {doubled, "triangle is there twice", "triangles are there twice"},
      {doubled > 0 ? 0 : topology.crowdedEdges, "edge has three or more triangles",
       "edges have three or more triangles"},
      {topology.turnedEdges, "edge has triangles that face different ways",
       "edges have triangles that face different ways"},
      {topology.pinchedCorners, "point is all that holds two parts together",
       "points are all that holds parts together"},
      {findInsideOut(welded, surface).size(), "closed part is inside out", "closed parts are inside out"}};
  std::vector<std::string> remarks;
  for (const Count& c : counts) {
    if (c.count > 0) remarks.push_back(file + ": " + countOf(c.count, c.one, c.many));
  }
  return remarks;
}

// The figures that keep it from being a match; empty where it is one.
std::string weakFigures(const MatchReport& report) {
  const MatchGrade grade = gradeOf(report);
  if (grade == MatchGrade::excellent || grade == MatchGrade::match || grade == MatchGrade::tooSmall)
    return {};
  const MatchBounds& good = boundsOf(MatchGrade::match);
  std::string why;
  const auto add = [&](bool weak, const std::string& what) {
    if (weak) why += (why.empty() ? "" : ", ") + what;
  };
  add(report.hiddenShare > good.hiddenShare, fmt::format("{:.1f} % hidden", 100 * report.hiddenShare));
  add(report.missedShare > good.missedShare, fmt::format("{:.1f} % missed", 100 * report.missedShare));
  add(report.foldedShare > 0, fmt::format("{:.1f} % folded", 100 * report.foldedShare));
  add(report.extraShare > good.extraShare,
      fmt::format("{:.1f} % beside the original", 100 * report.extraShare));
  add(report.comparedPixels > 0 && report.p99Px > good.p99Px,
      fmt::format("points {:.1f} px off", report.p99Px));
  add(report.contourPx > good.contourPx, fmt::format("outline {:.1f} px off", report.contourPx));
  return why;
}

void checkMesh(const LoadedMesh& loaded, const std::string& file, Finding& finding) {
  finding.warn(loaded.warnings);
  const Mesh& mesh = loaded.mesh;
  const Vector size = boundingBox(mesh.positions).size();
  const WeldedMesh welded = weldPositions(mesh);
  if (welded.mesh.triangles.empty()) throw Error("expected triangles with an area, got none", file);
  finding.warn(surfaceRemarks(welded.mesh, file));
  finding.summary = fmt::format("mesh, {}, {}, {:.4g} x {:.4g} x {:.4g}, {}",
                                countOf(mesh.positions.size(), "vertex", "vertices"),
                                countOf(mesh.triangles.size(), "triangle", "triangles"), size.x, size.y,
                                size.z, isClosed(welded.mesh) ? "closed" : "not closed");
}

void checkScene(const Level& level, Finding& finding) {
  // The mesh is not known, but its place is: the problems of mirror and eye show with that point alone.
  Box point;
  point.extend(level.original.placement.position);
  if (auto problem = findProblem(level, point)) throw Error(*problem);
  finding.summary = fmt::format("thesis scene, {} mirror", shapeName(level.optic.shape()));
}

void checkLevel(const std::string& path, const LoadedLevel& loaded, const CommonOptions& common,
                Finding& finding) {
  constexpr int matchSize = 512;  // as that of `anamorph match`: both say the same
  const Level& level = loaded.level;
  const auto shape = loadOriginal(level.original.shape, path, common.meshLimits());
  finding.warn(shape.warnings);
  const PlacedOriginal original = placeOriginal(*shape.mesh, level);
  const LevelResult finished = *finishLevel(level, original, common.threads);
  FileRemarks faults(path);
  checkLesson(loaded, original.mesh->positions.size(), faults);
  if (finished.problem) faults.addFault(*finished.problem, {}, placeOfProblem(level));
  faults.throwFaults();
  for (const std::string& warning : finished.warnings) finding.warn({path + ": " + warning});
  const MatchReport report = matchLevel(finished, matchSize, matchSize, common.threads).report;
  if (const auto problem = findMatchProblem(report)) finding.warn({path + ": " + *problem});
  if (const std::string why = weakFigures(report); !why.empty())
    finding.warn({fmt::format("{}: the match is {}: {}", path, matchGradeName(gradeOf(report)), why)});
  finding.summary = fmt::format("level \"{}\", {} {}, {} of {} vertices mapped, match {}", level.text->title,
                                shapeName(level.optic.shape()), surfaceName(level.optic),
                                finished.sculpture.sculpture->originalStatus[0],
                                original.mesh->positions.size(), matchGradeName(gradeOf(report)));
}

void checkLoaded(const std::string& path, const LoadedLevel& loaded, const CommonOptions& common,
                 Finding& finding) {
  finding.warn(loaded.warnings);
  try {
    if (loaded.isThesisScene) {
      checkScene(loaded.level, finding);
    } else {
      checkLevel(path, loaded, common, finding);
    }
  } catch (const Error& error) {
    if (error.file.empty()) throw Error(error.message, path);
    // A mesh that is not there is told by its path in the level alone.
    const JsonValue* named = error.where.empty() ? nullptr : findByPath(loaded.document, error.where);
    if (!named) throw;
    throw Error(error.message, error.file, whereText(named->place, error.where));
  }
}

// Levels are JSON objects, meshes never begin like one.
bool looksLikeJson(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  return first != std::string_view::npos && bytes[first] == '{';
}

void checkStandardInput(const CommonOptions& common, Finding& finding) {
  const MeshLimits limits = common.meshLimits();
  const FileBytes bytes = readStandardInput(limits.maxBytes, MeshLimits::bytesHelp);
  const std::string name = standardInputName;
  if (looksLikeJson(bytes.view())) {
    checkLoaded(name, withMirrors(parseLevel(bytes.view(), name), name, limits), common, finding);
  } else {
    checkMesh(readMesh(bytes.view(), name, limits), name, finding);
  }
}

void checkFile(const std::string& file, const CommonOptions& common, Finding& finding) {
  if (isStandardInput(file)) return checkStandardInput(common, finding);
  checkInput(file);
  if (isModelFile(file)) return checkMesh(loadMesh(file, common.meshLimits()), file, finding);
  const std::string path = findLevel(file).string();
  checkLoaded(path, withMirrors(loadLevel(path), path, common.meshLimits()), common, finding);
}

JsonValue faultsJson(const Error& error) {
  JsonValue list = emptyList();
  const auto add = [&](const Error& fault) {
    list.items.push_back(JsonObject().add("where", fault.where).add("message", fault.message).value());
  };
  for (const Error& fault : error.faults) add(fault);
  if (error.faults.empty()) add(error);
  return list;
}

// Tells of one file, or adds the same to the JSON. False when it has faults.
bool checkOne(const std::string& file, const CommonOptions& common, JsonValue& json) {
  Finding finding;
  std::optional<Error> fault;
  try {
    checkFile(file, common, finding);
  } catch (const Error& error) {
    fault = error;
  }
  JsonObject result;
  result.add("file", file).add("warnings", textList(finding.warnings));
  if (fault) result.add("faults", faultsJson(*fault));
  if (!fault) result.add("summary", finding.summary);
  json.items.push_back(result.value());
  if (!common.json) {
    flushResults();  // in order with what goes to stderr
    sayWarnings(common, finding.warnings);
    if (fault) printError(*fault);
    if (!fault) printLine(stdout, file + ": " + finding.summary);
  }
  return !fault;
}

void check(const std::vector<std::string>& files, const CommonOptions& common) {
  JsonValue list = emptyList();
  std::size_t bad = 0;
  for (const std::string& file : files) bad += !checkOne(file, common, list);
  if (common.json) {
    printJson(JsonObject().add("files", std::move(list)).add("withFaults", bad).value());
    flushResults();
  }
  if (bad > 0) throw Error(fmt::format("{} of {} files have faults", bad, files.size()));
}

}  // namespace

void addCheckCommand(CLI::App& app, CommonOptions& common) {
  CLI::App* command =
      app.add_subcommand("check", "Tell what is wrong with levels, thesis scenes and meshes, and where");
  const auto files = std::make_shared<std::vector<std::string>>();
  command->add_option("FILE", *files, "Levels, thesis scenes or meshes; - for standard input")->required();
  addJsonOption(*command, common);
  addCommonOptions(*command, common);
  command->callback([files, &common] { check(*files, common); });
}

}  // namespace anamorph
