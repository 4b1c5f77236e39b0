// anamorph match: how well the reflection agrees with the original.

#include <utility>

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/input.h"
#include "cli/print.h"
#include "cli/report.h"

namespace anamorph {
namespace {

struct MatchOptions {
  InputOptions input;
  std::pair<int, int> size{512, 512};
};

void printReport(const MatchReport& report, const StatusCounts& counts) {
  const auto line = [](const char* name, const std::string& value) {
    printLine(stdout, fmt::format("{:<19} {}", name, value));
  };
  line("match", matchGradeName(gradeOf(report)));
  if (const auto problem = findMatchProblem(report)) line("", *problem);
  line("outline", contourText(report.contourPx));
  line("silhouette IoU", fmt::format("{:.5f}", report.silhouetteIou));
  line("correspondence", report.comparedPixels > 0
                             ? fmt::format("mean {:.3f} px, p99 {:.3f} px, max {:.3f} px", report.meanPx,
                                           report.p99Px, report.maxPx)
                             : "no pixel shows both");
  line("triangle agreement", fmt::format("{:.5f}", report.triangleAgreement));
  line("hidden share", fmt::format("{:.5f}", report.hiddenShare));
  line("missed share", fmt::format("{:.5f}", report.missedShare));
  line("folded share", fmt::format("{:.5f}", report.foldedShare));
  line("extra share", fmt::format("{:.5f}", report.extraShare));
  line("status", statusSentence(counts));
}

void match(const MatchOptions& options, const CommonOptions& common) {
  Input input = loadInput(options.input, common);
  const auto [width, height] = options.size;
  input.level.sculpture.imageSize = height;
  const LevelResult finished = finishInput(input, common);
  const MatchReport report = matchInput(finished, width, height, common).report;
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
  addSizeOption(*command, options->size, limits::renderedSize.level);
  addJsonOption(*command, common);
  addCommonOptions(*command, common);
  command->callback([options, &common] { match(*options, common); });
}

}  // namespace anamorph
