#include "cli/output.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/file.h"
#include "base/folder.h"
#include "base/same_file.h"
#include "base/system_call.h"
#include "cli/print.h"
#include "cli/report.h"
#include "cli/usage_error.h"
#include "exports/export_formats.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

const fs::path standardOutput = "/dev/stdout";

fs::path targetOf(const std::string& name) {
  for (const char* same : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
    if (name == same) return standardOutput;
  }
  return name;
}

// In pieces: a sculpture may be large.
template <typename Take>
void copyFrom(std::ifstream& file, const Take& take) {
  std::array<char, 1 << 16> piece;
  while (file.read(piece.data(), piece.size()), file.gcount() > 0) {
    take(std::string_view(piece.data(), static_cast<std::size_t>(file.gcount())));
  }
  if (file.bad()) throw Error("the result cannot be read again: " + systemReason());
}

// "b.obj: ONE", or "./b.obj: this is b.obj, which TWO".
std::string sameAs(const std::string& name, const std::string& other, const char* one, const char* two) {
  return name + ": " + (name == other ? one : "this is " + other + ", which " + two);
}

// `before`: the outputs that are named before it.
void checkName(const std::vector<fs::path>& inputs, std::span<const Output> before, const Output& output,
               bool noClobber) {
  if (const auto input = findSameFile(output.target(), inputs)) {
    throw UsageError(sameAs(output.name(), *input, "this command reads it", "this command reads") +
                     "; choose another name for the output");
  }
  for (const Output& other : before) {
    if (output.target() != other.target() && !isSameFile(output.target(), other.target())) continue;
    throw UsageError(sameAs(output.name(), other.name(), "named twice as output", "is an output already"));
  }
  std::error_code ignored;
  if (noClobber && !output.isStream() && fs::exists(output.target(), ignored)) {
    throw UsageError(output.name() + ": exists, and --no-clobber keeps what exists");
  }
}

}  // namespace

void addNoClobber(CLI::App& command, CommonOptions& options) {
  command.add_flag("--no-clobber", options.noClobber, "Refuse to replace a file that exists");
}

void addFormat(CLI::App& command, std::string& format) {
  command.add_option("--format", format,
                     "The ending that says what is written by -o - (standard output): obj, ...");
}

Output::Output(std::string name, const std::string& format)
    : name_(std::move(name)), target_(targetOf(name_)), path_(target_) {
  std::error_code ignored;
  const bool stream = isStandardOutput() || fs::is_character_file(target_, ignored);
  if (!stream) return;
  const std::string ending = format.empty() ? lowerEnding(name_) : "." + format;
  if (ending.empty()) throw UsageError(name_ + ": expected --format, which says what is to be written there");
  folder_ = std::make_unique<ScratchFolder>();
  path_ = folder_->file("output" + ending);
}

bool Output::isStandardOutput() const {
  return target_ == standardOutput;
}

void Output::deliver() {
  if (!isStream()) return;
  std::ifstream file(path_, std::ios::binary);
  if (!file) throw Error("cannot be read again: " + systemReason(), path_.string());
  folder_.reset();  // now: who reads the output may end us at any time
  if (isStandardOutput()) {
    copyFrom(file, [](std::string_view piece) { printText(stdout, piece); });
    return flushResults();
  }
  AtomicFile device(target_);
  copyFrom(file, [&](std::string_view piece) { device.write(piece); });
  device.commit();
}

std::vector<Output> makeOutputs(const std::vector<std::string>& names, const std::string& format) {
  std::vector<Output> outputs;
  for (const std::string& name : names) outputs.emplace_back(name, format);
  const bool needed =
      std::any_of(outputs.begin(), outputs.end(), [](const Output& o) { return o.isStream(); });
  if (!format.empty() && !needed)
    throw UsageError("--format: expected -o -, as the endings of files say what they are");
  return outputs;
}

Output pictureOutput(const std::string& name, const CommonOptions& common) {
  Output output(name, "png");
  const ExportFormat& picture = formatOf(ExportKind::picture);
  if (!hasEnding(picture, output.path())) throw UsageError(wrongEnding(name, picture.endings));
  if (output.isStandardOutput() && common.json) throw UsageError(jsonInTheWay);
  return output;
}

void sayPicture(const CommonOptions& common, const Output& output, int width, int height,
                const std::string& what) {
  if (!common.json)
    return sayMessage(common, fmt::format("{}: {} x {} pixels", output.name(), width, height));
  printJson(JsonObject()
                .add("path", output.name())
                .add("picture", what)
                .add("width", static_cast<std::size_t>(width))
                .add("height", static_cast<std::size_t>(height))
                .value());
}

void checkOutputs(const std::vector<fs::path>& inputs, std::span<const Output> outputs, bool noClobber) {
  for (std::size_t i = 0; i < outputs.size(); ++i) checkName(inputs, outputs.first(i), outputs[i], noClobber);
  for (const Output& output : outputs) {
    if (!output.isStream()) AtomicFile probe(output.path());
  }
}

}  // namespace anamorph
