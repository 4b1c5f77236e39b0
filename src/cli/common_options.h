// Options that all commands understand, and how they speak to people.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/progress.h"
#include "geometry/mesh_files.h"
#include "level/limits.h"
#include "pipeline/picture.h"

namespace anamorph {

struct CommonOptions {
  int threads = 0;  ///< 0: all
  bool quiet = false;
  bool json = false;
  bool noClobber = false;  ///< outputs that exist are refused
  std::size_t maxMeshMebibytes = 2048;
  std::size_t maxVertices = 50'000'000;

  MeshLimits meshLimits() const;
};

void addCommonOptions(CLI::App& command, CommonOptions& options);

/// Accepts finite numbers of the range and says so otherwise. (CLI11's own Range lets nan pass.)
CLI::Validator numberIn(const Range& range);

/// --size N, which is a square, or WIDTHxHEIGHT, in pixels, with sides of the range; `size` has the default and lives as
/// long as the command.
CLI::Option* addSizeOption(CLI::App& command, std::pair<int, int>& size,
                           const Range& sides = limits::pictureSide);
/// --size N or WIDTHxHEIGHT where a number alone means something else: `take` gets no height then.
CLI::Option* addSizeOption(CLI::App& command, std::function<void(int, std::optional<int>)> take,
                           const Range& sides, const std::string& help);

/// --json.
void addJsonOption(CLI::App& command, CommonOptions& options);

/// --picture, once --view, which still works: reflection, original or difference. `kind` lives as long as the command.
void addPictureOption(CLI::App& command, PictureKind& kind, const std::string& help);
const char* pictureName(PictureKind kind);

/// --language, one of those that are installed; `code` lives as long as the command.
void addLanguageOption(CLI::App& command, std::string& code, const std::string& help);

/// One line on stderr, unless --quiet.
void sayMessage(const CommonOptions& options, const std::string& text);
void sayWarnings(const CommonOptions& options, const std::vector<std::string>& warnings);

/// A bar on stderr for what takes longer than a second, when stderr is a terminal. Gone when done.
class ProgressBar {
 public:
  ProgressBar(const CommonOptions& options, std::string what);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  const Progress& progress() const { return progress_; }

 private:
  void draw(double fraction);

  std::string what_;
  double startSeconds_;
  double drawnSeconds_ = 0;
  bool drawn_ = false;
  Progress progress_;
};

/// What is printed waits in a buffer, so a full disk shows only now. Throws Error.
void flushResults();

/// Seconds of a clock that only goes forward.
double secondsNow();

}  // namespace anamorph
