// anamorph export: everything of a level that can be taken home, as files.

#include <algorithm>
#include <charconv>
#include <map>

#include <fmt/format.h>

#include "base/error.h"
#include "base/folder.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/print.h"
#include "cli/report.h"
#include "cli/usage_error.h"
#include "exports/export_formats.h"
#include "exports/export_level.h"
#include "level/languages.h"

namespace anamorph {
namespace {

struct ExportOptions {
  InputOptions input;
  std::vector<std::string> outputs;
  std::string format;
  bool check = false;
  double millimetresPerUnit = 10;
  double smallestWidth = ExportRequest{}.smallestWidth;
  std::optional<double> basePlate;
  double plateMargin = BasePlateSettings{}.margin;
  std::string page = "A4";
  std::string scale = "fit";
  std::string rays;  // empty: .obj is the sculpture
  PictureKind picture = PictureKind::reflection;
  int size = 512;  // of the longer side
  std::optional<std::pair<int, int>> exactSize;
  std::string language = "en";
};

// A number that is the whole of the text and in the range.
template <typename Number>
std::optional<Number> parseNumber(std::string_view text, const Range& range) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  const bool whole = result.ec == std::errc() && result.ptr == end;
  return whole && range.holds(static_cast<double>(number)) ? std::optional(number) : std::nullopt;
}

// "1:2" is 2; "fit" is nothing.
std::optional<double> parseScale(const std::string& text) {
  if (text == "fit") return std::nullopt;
  const std::size_t colon = text.find(':');
  if (colon != std::string::npos) {
    const auto paper = parseNumber<double>(std::string_view(text).substr(0, colon), limits::scaleOnPaper);
    const auto life = parseNumber<double>(std::string_view(text).substr(colon + 1), limits::scaleInLife);
    if (paper && life) return *life / *paper;
  }
  throw UsageError("--scale: expected fit or a ratio as 1:2, got " + text);
}

// How many vertices; nothing for the pixel grid.
std::optional<int> parseRays(const std::string& text) {
  if (text == "pixels") return std::nullopt;
  if (text == "vertices") return 200;
  const std::string vertices = "vertices:";
  constexpr Range counts = limits::exportedVertexRays.level;
  if (text.starts_with(vertices)) {
    if (const auto count = parseNumber<int>(std::string_view(text).substr(vertices.size()), counts)) {
      return *count;
    }
  }
  throw UsageError(
      fmt::format("--rays: expected vertices, vertices:N with N from {} to {}, or pixels, got {}", counts.min,
                  counts.max, text));
}

// "viewing sheet"
std::string nameOf(const ExportFormat& format) {
  return lowerCase(format.name);
}

// "sculpture", and what else files with its endings can be when it is asked for.
std::string meaningOf(const ExportFormat& format) {
  std::string meaning = nameOf(format);
  for (const ExportFormat& other : exportFormats()) {
    if (!other.askedBy || !hasEnding(format, other.fileName)) continue;
    meaning += fmt::format("; with {} {} is its {}", other.askedBy, exportEndings(other.kind), nameOf(other));
  }
  return meaning;
}

// ".pdf or .svg (viewing sheet), .html or .json (match report) or ..."
std::string allEndings() {
  std::vector<std::string> formats;
  for (const ExportFormat& format : exportFormats()) {
    if (!format.askedBy) formats.push_back(exportEndings(format.kind) + " (" + meaningOf(format) + ")");
  }
  return alternatives(formats);
}

ExportRequest makeRequest(const ExportOptions& options, const Output& output) {
  static const std::map<std::string, Paper> papers{
      {"A4", Paper::a4}, {"A3", Paper::a3}, {"letter", Paper::letter}};
  ExportRequest request;
  const auto kind = findExportKind(output.path());
  if (!kind) {
    throw UsageError(output.name() + ": expected an output file that ends in " + allEndings());
  }
  request.kind = *kind;
  request.path = output.path();
  request.millimetresPerUnit = options.millimetresPerUnit;
  if (options.basePlate) request.basePlate = BasePlateSettings{*options.basePlate, options.plateMargin};
  request.paper = papers.at(options.page);
  request.sheetScale = parseScale(options.scale);
  request.picture = options.picture;
  request.size = options.size;
  request.exactSize = options.exactSize;
  if (!options.rays.empty()) {
    request.vertexRays = parseRays(options.rays);
    if (hasEnding(formatOf(ExportKind::rays), output.path())) request.kind = ExportKind::rays;
  }
  return request;
}

bool anyHas(const std::vector<ExportRequest>& requests, ExportOption option) {
  return std::any_of(requests.begin(), requests.end(),
                     [&](const ExportRequest& request) { return formatOf(request.kind).has(option); });
}

bool takesStandardOutput(const std::vector<Output>& outputs) {
  return std::any_of(outputs.begin(), outputs.end(), [](const Output& o) { return o.isStandardOutput(); });
}

std::vector<ExportRequest> makeRequests(const ExportOptions& options, const std::vector<Output>& outputs) {
  std::vector<ExportRequest> requests;
  for (const Output& output : outputs) requests.push_back(makeRequest(options, output));
  if (requests.empty() && !options.check) {
    throw UsageError("expected -o FILE, or --check to look at the sculpture only");
  }
  if (!options.rays.empty() && !anyHas(requests, ExportOption::raysOf)) {
    throw UsageError("--rays: expected an output file that ends in " + exportEndings(ExportKind::rays));
  }
  return requests;
}

// Writes one file; what was written, and what is to be known of it, as JSON. Throws Error.
JsonValue exportOne(const LevelResult& finished, const ExportRequest& request, Output& output,
                    const CommonOptions& common) {
  const ExportSummary summary = [&] {
    const ProgressBar bar(common, "exporting");
    return *exportLevel(finished, request, common.threads, bar.progress());
  }();
  output.deliver();
  if (!common.json) sayMessage(common, output.name() + ": " + summary.description);
  sayWarnings(common, summary.warnings);
  return JsonObject()
      .add("path", output.name())
      .add("description", summary.description)
      .add("warnings", textList(summary.warnings))
      .value();
}

// Writes the files; one that fails is told of, and the others are written all the same. Returns how many failed.
std::size_t writeFiles(const LevelResult& finished, const std::vector<ExportRequest>& requests,
                       std::vector<Output>& outputs, const CommonOptions& common, JsonValue& files) {
  std::size_t failed = 0;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    try {
      files.items.push_back(exportOne(finished, requests[i], outputs[i], common));
    } catch (const Error& error) {
      const Error named(error.message, outputs[i].name(), error.where);
      if (outputs.size() == 1) throw named;
      printLine(stderr, named.what());
      files.items.push_back(
          JsonObject().add("path", outputs[i].name()).add("error", std::string(named.what())).value());
      ++failed;
    }
  }
  return failed;
}

void exportFiles(const ExportOptions& options, const CommonOptions& common) {
  std::vector<Output> outputs = makeOutputs(options.outputs, options.format);
  const std::vector<ExportRequest> requests = makeRequests(options, outputs);
  chooseLanguage(options.language);
  const bool piped = takesStandardOutput(outputs);
  if (piped && common.json) throw UsageError(jsonInTheWay);
  const LevelResult finished = finishInput(loadInput(options.input, common, outputs), common);
  JsonValue files = emptyList();
  const std::size_t failed = writeFiles(finished, requests, outputs, common, files);
  JsonObject json;
  json.add("files", std::move(files));
  if (options.check || anyHas(requests, ExportOption::printCheck)) {
    const PrintCheck check = [&] {
      const ProgressBar bar(common, "checking");
      ExportRequest request;
      request.millimetresPerUnit = options.millimetresPerUnit;
      request.smallestWidth = options.smallestWidth;
      return *checkSculpture(finished, request, common.threads, bar.progress());
    }();
    const LeftOut leftOut = leftOutOf(finished);
    json.add("printCheck", printCheckJson(check, leftOut));
    if (!common.json) printText(piped ? stderr : stdout, formatPrintReport(check, leftOut));
  }
  if (common.json) printJson(json.value());
  if (failed == 0) return;
  flushResults();
  throw Error(fmt::format("{} of {} files could not be written", failed, outputs.size()));
}

std::string joined(const auto& parts, const char* between) {
  std::string text;
  for (const auto& part : parts) text += (text.empty() ? "" : between) + std::string(part);
  return text;
}

// "sculpture, viewing sheet, ..."
std::string allNames() {
  std::vector<std::string> names;
  for (const ExportFormat& format : exportFormats()) names.push_back(nameOf(format));
  return joined(names, ", ");
}

std::string outputHelp() {
  std::vector<std::string> files;
  for (const ExportFormat& format : exportFormats()) {
    if (!format.askedBy) files.push_back(joined(format.endings, " ") + " (" + nameOf(format) + ")");
  }
  return "The file to write, as often as wanted: " + joined(files, ", ");
}

}  // namespace

void addExportCommand(CLI::App& app, CommonOptions& common) {
  CLI::App* command = app.add_subcommand("export", "Write what can be taken home: " + allNames());
  const auto options = std::make_shared<ExportOptions>();
  addInputOptions(*command, options->input);
  command->add_option("-o,--output", options->outputs, outputHelp())->allow_extra_args(false);
  addFormat(*command, options->format);
  addNoClobber(*command, common);
  command->add_flag("--check", options->check, "Print whether the sculpture can be printed, also without -o");
  command
      ->add_option("--mm-per-unit", options->millimetresPerUnit,
                   "Millimetres per scene unit of sculpture, sheet and rays (default 10)")
      ->check(numberIn(limits::millimetresPerUnit.level));
  command
      ->add_option(
          "--smallest-width", options->smallestWidth,
          "Width of the thinnest wall that the printer makes, in mm, for the print check (default 0.8)")
      ->check(numberIn(limits::smallestWidth.level));
  command
      ->add_option("--base-plate", options->basePlate,
                   "Thickness in mm of a plate under the sculpture, on posts")
      ->check(numberIn(limits::plateThickness.level));
  command
      ->add_option("--plate-margin", options->plateMargin,
                   "How far the base plate goes beyond the sculpture's outline, in mm (default 3)")
      ->check(numberIn(limits::plateMargin.level))
      ->needs("--base-plate");
  command->add_option("--page", options->page, "Paper of the viewing sheet: A4 (default), A3 or letter")
      ->check(CLI::IsMember({"A4", "A3", "letter"}));
  command->add_option("--scale", options->scale,
                      "Scale of the viewing sheet, as 1:2; fit (default): 1:1 or the largest that fits");
  command->add_option(
      "--rays", options->rays,
      "Write rays to the .obj file instead of the sculpture: vertices:N of N vertices, or pixels");
  addPictureOption(*command, options->picture, "What a .png shows");
  const auto takeSize = [options = options.get()](int width, std::optional<int> height) {
    if (height) options->exactSize = {width, *height};
    options->size = width;
  };
  addSizeOption(*command, takeSize, limits::exportedSize.level,
                "Of picture and match report's pictures in pixels: N, the longer side (default 512), or "
                "WIDTHxHEIGHT");
  addLanguageOption(*command, options->language,
                    "Of viewing sheet, match report and what is said of the files: en, nl, ... (default en)");
  addJsonOption(*command, common);
  addCommonOptions(*command, common);
  command->callback([options, &common] { exportFiles(*options, common); });
}

}  // namespace anamorph
