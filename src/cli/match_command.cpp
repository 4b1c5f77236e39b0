// anamorph match: how well the reflection agrees with the original.

#include <fmt/format.h>

#include "anamorphosis/contour.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/report.h"

namespace anamorph {
namespace {

struct MatchOptions {
  InputOptions input;
  int size = 512;
};

void printReport(const MatchReport& report, const StatusCounts& counts) {
  fmt::print("match               {}\n", matchGradeName(gradeOf(report)));
  if (const auto problem = findMatchProblem(report)) fmt::print("                    {}\n", *problem);
  fmt::print("outline             {}\n", report.contourPx < farthestContour
                                             ? fmt::format("{:.2f} px", report.contourPx)
                                             : fmt::format("{:g} px or more", farthestContour));
  fmt::print("silhouette IoU      {:.5f}\n", report.silhouetteIou);
  if (report.comparedPixels > 0) {
    fmt::print("correspondence      mean {:.3f} px, p99 {:.3f} px, max {:.3f} px\n", report.meanPx,
               report.p99Px, report.maxPx);
  } else {
    fmt::print("correspondence      no pixel shows both\n");
  }
  fmt::print("triangle agreement  {:.5f}\n", report.triangleAgreement);
  fmt::print("hidden share        {:.5f}\n", report.hiddenShare);
  fmt::print("missed share        {:.5f}\n", report.missedShare);
  fmt::print("extra share         {:.5f}\n", report.extraShare);
  fmt::print("status              {}\n", statusSentence(counts));
}

void match(const MatchOptions& options, const CommonOptions& common) {
  Input input = loadInput(options.input, common);
  input.level.sculpture.imageSize = options.size;
  const LevelResult finished = finishInput(input, common);
  const MatchReport report = matchInput(finished, options.size, options.size, common).report;
  const StatusCounts& counts = finished.sculpture.sculpture->originalStatus;
  if (common.json) {
    printJson(matchJson(report, counts));
  } else {
    printReport(report, counts);
  }
}

}  // namespace

void addMatchCommand(CLI::App& app, CommonOptions& common) {
  CLI::App* command =
      app.add_subcommand("match", "Compare what the mirror shows with the original, in figures");
  const auto options = std::make_shared<MatchOptions>();
  addInputOptions(*command, options->input);
  command
      ->add_option("--size", options->size, "Width and height of the compared image in pixels (default 512)")
      ->check(numberIn(limits::renderedSize.level));
  command->add_flag("--json", common.json, "Print one JSON object on stdout");
  addCommonOptions(*command, common);
  command->callback([options, &common] { match(*options, common); });
}

}  // namespace anamorph
