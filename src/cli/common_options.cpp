#include "cli/common_options.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/language.h"
#include "base/system_call.h"
#include "base/text.h"
#include "cli/print.h"
#include "level/languages.h"

namespace anamorph {
namespace {

constexpr std::array pictureNames{"reflection", "original", "difference"};  // in the order of PictureKind

// A whole number that is all of the text, and of the range.
std::optional<int> parseSide(std::string_view text, const Range& sides) {
  int side = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, side);
  const bool whole = read.ec == std::errc() && read.ptr == end;
  return whole && sides.holds(side) ? std::optional(side) : std::nullopt;
}

// "N" to one number, "WxH" to two.
std::pair<int, std::optional<int>> parseSize(const std::string& text, const Range& sides) {
  const std::string_view all = text;
  const std::size_t cross = all.find('x');
  const std::optional<int> width = parseSide(all.substr(0, cross), sides);
  std::optional<int> height;
  if (cross != std::string::npos) height = parseSide(all.substr(cross + 1), sides);
  if (!width || (cross != std::string::npos && !height)) {
    throw CLI::ValidationError(
        "--size", fmt::format("expected N or WIDTHxHEIGHT with sides from {:.0f} to {:.0f}, got {}",
                              sides.min, sides.max, text));
  }
  return {*width, height};
}

std::string installedLanguages() {
  std::vector<std::string> codes;
  for (const LanguageChoice& language : listLanguages()) codes.push_back(language.code);
  return alternatives(codes);
}

}  // namespace

MeshLimits CommonOptions::meshLimits() const {
  MeshLimits limits;
  limits.maxBytes = maxMeshMebibytes << 20;
  limits.maxVertices = maxVertices;
  return limits;
}

void addCommonOptions(CLI::App& command, CommonOptions& options) {
  command.add_option("--threads", options.threads, "Threads to use (default: all)")
      ->check(numberIn(limits::threads));
  command.add_flag("--quiet", options.quiet, "No messages and no progress bar, only results and errors");
  command
      .add_option("--max-mesh-mb", options.maxMeshMebibytes,
                  "Largest mesh file to read, in MiB (default 2048)")
      ->check(numberIn(limits::meshMebibytes));
  command.add_option("--max-vertices", options.maxVertices, "Most vertices to read (default 50000000)")
      ->check(numberIn(limits::meshVertices));
}

CLI::Validator numberIn(const Range& range) {
  const std::string ends = shownNumber(range.min, ".10g") + " to " + shownNumber(range.max, ".10g");
  return CLI::Validator(
      [=](std::string& text) {
        double number = 0;
        const bool inRange = CLI::detail::lexical_cast(text, number) && range.holds(number);
        return inRange ? std::string() : "expected a number from " + ends + ", got " + text;
      },
      ends);
}

CLI::Option* addSizeOption(CLI::App& command, std::pair<int, int>& size, const Range& sides) {
  const auto take = [&size](int width, std::optional<int> height) { size = {width, height.value_or(width)}; };
  return addSizeOption(
      command, take, sides,
      fmt::format("N (a square) or WIDTHxHEIGHT in pixels (default {}x{})", size.first, size.second));
}

CLI::Option* addSizeOption(CLI::App& command, std::function<void(int, std::optional<int>)> take,
                           const Range& sides, const std::string& help) {
  return command.add_option_function<std::string>(
      "--size",
      [take = std::move(take), sides](const std::string& text) {
        const auto [width, height] = parseSize(text, sides);
        take(width, height);
      },
      help);
}

void addJsonOption(CLI::App& command, CommonOptions& options) {
  command.add_flag("--json", options.json, "Print one JSON object on stdout");
}

void addPictureOption(CLI::App& command, PictureKind& kind, const std::string& help) {
  command
      .add_option_function<std::string>(
          "--picture,--view",
          [&kind](const std::string& name) {
            const auto found = std::find(pictureNames.begin(), pictureNames.end(), name);
            kind = static_cast<PictureKind>(found - pictureNames.begin());
          },
          help + ": reflection (default), original or difference; --view is its old name")
      ->check(CLI::IsMember(std::vector<std::string>(pictureNames.begin(), pictureNames.end())));
}

const char* pictureName(PictureKind kind) {
  return pictureNames[static_cast<std::size_t>(kind)];
}

void addLanguageOption(CLI::App& command, std::string& code, const std::string& help) {
  command.add_option("--language", code, help)->check([](const std::string& wanted) {
    const std::vector<LanguageChoice> all = listLanguages();
    const bool known = std::any_of(all.begin(), all.end(),
                                   [&](const LanguageChoice& language) { return language.code == wanted; });
    return known ? std::string() : "expected " + installedLanguages() + ", got " + wanted;
  });
}

void sayMessage(const CommonOptions& options, const std::string& text) {
  if (!options.quiet) printLine(stderr, text);
}

void sayWarnings(const CommonOptions& options, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) sayMessage(options, "warning: " + warning);
}

void flushResults() {
  if (std::fflush(stdout) != 0) throw Error("cannot write: " + systemReason(), "stdout");
}

double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

ProgressBar::ProgressBar(const CommonOptions& options, std::string what)
    : what_(std::move(what)), startSeconds_(secondsNow()) {
  if (!options.quiet && isatty(fileno(stderr)) != 0) {
    progress_.report = [this](double fraction) { draw(fraction); };
  }
}

ProgressBar::~ProgressBar() {
  if (drawn_) printText(stderr, fmt::format("\r{:60}\r", ""));
}

void ProgressBar::draw(double fraction) {
  const double now = secondsNow();
  if (now - startSeconds_ < 1 || now - drawnSeconds_ < 0.1) return;
  constexpr int width = 30;
  const int filled = static_cast<int>(fraction * width);
  printText(stderr, fmt::format("\r{} [{:#<{}}{:<{}}] {:3.0f} %", what_, "", filled, "", width - filled,
                                100 * fraction));
  drawnSeconds_ = now;
  drawn_ = true;
}

}  // namespace anamorph
