#include "cli/common_options.h"

#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cstdio>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/system_call.h"
#include "cli/print.h"

namespace anamorph {
namespace {

// "WxH" to two numbers.
std::pair<int, int> parseSize(const std::string& text) {
  const char* end = text.data() + text.size();
  int width = 0, height = 0;
  const auto first = std::from_chars(text.data(), end, width);
  const bool cross = first.ec == std::errc() && first.ptr != end && *first.ptr == 'x';
  const auto second = cross ? std::from_chars(first.ptr + 1, end, height) : first;
  if (!cross || second.ec != std::errc() || second.ptr != end || !limits::pictureSide.holds(width) ||
      !limits::pictureSide.holds(height)) {
    throw CLI::ValidationError("--size", fmt::format("expected WIDTHxHEIGHT with sides from {} to {}, got {}",
                                                     limits::pictureSide.min, limits::pictureSide.max, text));
  }
  return {width, height};
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
  const std::string ends = fmt::format("{:.10g} to {:.10g}", range.min, range.max);
  return CLI::Validator(
      [=](std::string& text) {
        double number = 0;
        const bool inRange = CLI::detail::lexical_cast(text, number) && range.holds(number);
        return inRange ? std::string() : "expected a number from " + ends + ", got " + text;
      },
      ends);
}

void addSizeOption(CLI::App& command, std::pair<int, int>& size) {
  command.add_option_function<std::string>(
      "--size", [&size](const std::string& text) { size = parseSize(text); },
      fmt::format("WIDTHxHEIGHT in pixels (default {}x{})", size.first, size.second));
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
