#include "exports/match_report_files.h"

#include <cstdint>

#include <fmt/format.h>

#include "base/language.h"
#include "level/freeze.h"
#include "math/palette.h"
#include "raytrace/png.h"

namespace anamorph {
namespace {

constexpr const char* style = R"(
body { font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; max-width: 64rem; margin: 2rem auto; padding: 0 1rem;
       color: #1b1f24; background: #fff; }
h1 { margin: 0; font-size: 1.7rem; }
.grade { display: inline-block; margin: .5rem 0 1rem; padding: .15rem .8rem; border-radius: 1rem; color: #fff;
         background: #0072b2; font-weight: 600; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(16rem, 1fr)); gap: 1rem; }
figure { margin: 0; }
img { width: 100%; height: auto; display: block; border-radius: 4px; }
figcaption { font-size: .9rem; margin-top: .4rem; }
table { border-collapse: collapse; margin: 1.5rem 0; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: .45rem .8rem .45rem 0; border-top: 1px solid #d5d9de; }
th { font-weight: 600; white-space: nowrap; }
td.number { font-variant-numeric: tabular-nums; white-space: nowrap; }
.kind { white-space: nowrap; }
.swatch { display: inline-block; width: .8em; height: .8em; border-radius: 2px; margin: 0 .25em 0 .5em; }
.small { font-size: .9rem; color: #57606a; }
)";

// The colours of markDifferences().
std::string legend() {
  constexpr std::pair<Rgb, const char*> colors[] = {{palette::onlyOriginal, "only the original"},
                                                    {palette::onlyReflection, "only the reflection"},
                                                    {palette::hiddenReflection, "hidden"},
                                                    {palette::noMirror, "no mirror"}};
  std::string text = tr("grey: both agree");
  for (const auto& [color, meaning] : colors) {
    text += fmt::format(
        "; <span class=\"kind\"><span class=\"swatch\" style=\"background:#{:06x}\"></span>{}</span>",
        static_cast<std::uint32_t>(color), tr(meaning));
  }
  return text;
}

std::string escapeHtml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else
      escaped += c;
  }
  return escaped;
}

std::string figure(const Image& image, const std::string& name, const std::string& caption) {
  return fmt::format(
      "<figure><img alt=\"{}\" width=\"{}\" height=\"{}\" src=\"data:image/png;base64,{}\">"
      "<figcaption><b>{}</b>: {}</figcaption></figure>\n",
      tr(name), image.width, image.height, encodeBase64(encodePng(toBitmap(image))), tr(name), caption);
}

std::string row(const char* name, const std::string& value, const std::string& good, const char* meaning) {
  return fmt::format(
      "<tr><th>{}</th><td class=\"number\">{}</td><td class=\"number\">{}</td><td>{}</td></tr>\n", tr(name),
      value, good, tr(meaning));
}

// What a figure may be at most; of what is never negative 0 is all there is.
std::string atMost(double bound, const char* unit = "") {
  return shownFormat("{}{:g}{}", bound > 0 ? "&le; " : "", bound, unit);
}

std::string figuresTable(const MatchReport& report) {
  const bool compared = report.comparedPixels > 0;
  const MatchBounds& best = boundsOf(MatchGrade::excellent);
  std::string text = fmt::format("<table>\n<tr><th>{}</th><th>{}</th><th>{}</th><th>{}</th></tr>\n",
                                 tr("figure"), tr("here"), tr("excellent"), tr("what it says"));
  text += row("outline, 99 %", contourText(report.contourPx), atMost(best.contourPx, " px"),
              "how far the outlines of both pictures are apart; 99 of 100 points of them are nearer");
  text += row("silhouette IoU", shownFormat("{:.5f}", report.silhouetteIou), "",
              "pixels that both pictures show, of those that either shows: 1 when the outlines are the same");
  text +=
      row("correspondence, 99 %", compared ? shownFormat("{:.3f} px", report.p99Px) : std::string(tr("none")),
          atMost(best.p99Px, " px"),
          "how far a reflected point is from where it should be; 99 of 100 points are nearer");
  text += row("correspondence, mean",
              compared ? shownFormat("{:.3f} px", report.meanPx) : std::string(tr("none")), "",
              "the same, on average");
  text += row("correspondence, worst",
              compared ? shownFormat("{:.3f} px", report.maxPx) : std::string(tr("none")), "",
              "the same, at the worst pixel");
  text += row("triangle agreement", shownFormat("{:.5f}", report.triangleAgreement),
              shownFormat("&ge; {:g}", best.triangleAgreement),
              "share of pixels in which both pictures show the same part of the original, front and back not "
              "swapped");
  text += row("hidden share", shownFormat("{:.5f}", report.hiddenShare), atMost(best.hiddenShare),
              "of the original's pixels: the sculpture itself, the floor or a base plate stands in the way");
  text += row("missed share", shownFormat("{:.5f}", report.missedShare), atMost(best.missedShare),
              "of the original's pixels: there is no mirror");
  text += row(
      "folded share", shownFormat("{:.5f}", report.foldedShare), "",
      "of the original: rays have crossed before they reach this part of the sculpture, so it is left out");
  text += row("extra share", shownFormat("{:.5f}", report.extraShare), atMost(best.extraShare),
              "pixels that show the sculpture beside the original, over the original's pixels");
  return text + "</table>\n";
}

std::string levelSentence(const LevelResult& finished) {
  const Level& level = finished.level;
  const Sculpture& sculpture = *finished.sculpture.sculpture;
  const Point& eye = level.camera.eye;
  const SculptureInputs inputs = sculptureInputs(level);
  return trFormat(
      "A {} {}, seen from the eye at ({:g}, {:g}, {:g}); depth scale {:g}, offset {:g}; the sculpture has {} "
      "triangles; {}.",
      tr(shapeName(level.optic.shape())), tr(surfaceName(level.optic)), eye.x, eye.y, eye.z,
      inputs.depthScale, inputs.depthOffset, sculpture.mesh.triangles.size(),
      shownStatus(sculpture.originalStatus));
}

}  // namespace

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
      .add("width", static_cast<std::size_t>(report.width))
      .add("height", static_cast<std::size_t>(report.height))
      .add("originalPixels", report.originalPixels)
      .add("contourPx", report.contourPx)
      .add("silhouetteIou", report.silhouetteIou)
      .add("correspondencePx", correspondence)
      .add("triangleAgreement", report.triangleAgreement)
      .add("hiddenShare", report.hiddenShare)
      .add("missedShare", report.missedShare)
      .add("foldedShare", report.foldedShare)
      .add("extraShare", report.extraShare)
      .add("grade", std::string(matchGradeName(gradeOf(report))))
      .add("status", statusJson(counts))
      .value();
}

std::string makeMatchPage(const LevelResult& finished, const MatchReport& report,
                          const MatchPictures& pictures) {
  std::string remarks;
  for (const auto& remark : {frozenSentence(finished.level), findMatchProblem(report)}) {
    if (remark) remarks += " (" + *remark + ")";
  }
  const std::string title =
      escapeHtml(tr(finished.level.text->title.empty() ? "Anamorphosis" : finished.level.text->title));
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<title>{}: {}</title>\n<style>{}</style>\n</head>\n<body>\n",
      tr("en"), title, tr("match report"), style);
  page +=
      fmt::format("<h1>{}</h1>\n<p class=\"grade\">{}: {}</p>\n<p>{}</p>\n<div class=\"pictures\">\n", title,
                  tr("match"), tr(matchGradeName(gradeOf(report))), levelSentence(finished) + remarks);
  page += figure(pictures.reflection, "Reflection",
                 isVisible(finished.level.optic) ? tr("what the eye sees in the mirror")
                                                 : tr("what the eye sees of the sculpture"));
  page += figure(pictures.original, "Original", tr("the original alone, seen directly from the same eye"));
  page += figure(pictures.difference, "Difference", legend());
  page += "</div>\n" + figuresTable(report);
  page += "<p class=\"small\">" +
          trFormat(
              "Compared in {} x {} pixels, two rays each: one straight to the original, one "
              "by way of the mirror to the sculpture. Made by Anamorph.",
              report.width, report.height) +
          "</p>\n</body>\n</html>\n";
  return page;
}

std::string encodeBase64(std::string_view bytes) {
  constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    // Three bytes are four letters; what is missing at the end is written as '='.
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? letters[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace anamorph
