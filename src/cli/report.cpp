#include "cli/report.h"

#include <fmt/format.h>

namespace anamorph {

JsonValue statusJson(const StatusCounts& counts) {
  JsonObject status;
  for (std::size_t i = 0; i < counts.size(); ++i)
    status.add(pathStatusName(static_cast<PathStatus>(i)), counts[i]);
  return status.value();
}

JsonValue matchJson(const MatchReport& report, const StatusCounts& counts) {
  JsonValue correspondence;
  if (report.comparedPixels > 0) {
    correspondence =
        JsonObject().add("mean", report.meanPx).add("p99", report.p99Px).add("max", report.maxPx).value();
  }
  return JsonObject()
      .add("size", static_cast<std::size_t>(report.height))
      .add("silhouetteIou", report.silhouetteIou)
      .add("correspondencePx", correspondence)
      .add("triangleAgreement", report.triangleAgreement)
      .add("hiddenShare", report.hiddenShare)
      .add("missedShare", report.missedShare)
      .add("grade", std::string(matchGradeName(gradeOf(report))))
      .add("status", statusJson(counts))
      .value();
}

void printJson(const JsonValue& value) {
  fmt::print("{}", formatJson(value));
}

}  // namespace anamorph
