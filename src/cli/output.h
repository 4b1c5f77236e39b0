// The files that a command writes, and where they must not go. All names are looked at in one place, before anything is
// computed: an output that is an input would cost the input, two outputs that are one file would cost the first.
//
//   -o a.obj      written to its place, in one step
//   -o -          made as a temporary file, then copied to standard output: all of it, or nothing
//   -o /dev/null  likewise, to the device
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/temporary_file.h"
#include "cli/common_options.h"

namespace anamorph {

/// --no-clobber, of all commands that write.
void addNoClobber(CLI::App& command, CommonOptions& options);
/// --format, an ending without its dot: of outputs that are no files and so have none.
void addFormat(CLI::App& command, std::string& format);

class Output {
 public:
  /// `format` is of an output that is no file: -, /dev/stdout or a device. Throws UsageError when one needs it.
  explicit Output(std::string name, const std::string& format = {});

  /// For messages.
  const std::string& name() const { return name_; }
  /// The file to write, whose ending says the format.
  const std::filesystem::path& path() const { return path_; }
  /// Where that goes in the end: the same, or a device.
  const std::filesystem::path& target() const { return target_; }
  bool isStandardOutput() const;
  bool isStream() const { return folder_ != nullptr; }

  /// The file has been written: brings it to where it is wanted. Throws Error.
  void deliver();

 private:
  std::string name_;
  std::filesystem::path target_, path_;
  std::unique_ptr<ScratchFolder> folder_;  // of path_, where that is temporary
};

/// The outputs of one command. Throws UsageError, also when `format` is given and no output needs it.
std::vector<Output> makeOutputs(const std::vector<std::string>& names, const std::string& format);

/// An output for a picture. Throws UsageError when its name does not end in .png, and when standard output is to have
/// the picture and --json.
Output pictureOutput(const std::string& name, const CommonOptions& common);

/// Says that a picture has been written: `what` it shows is for --json only.
void sayPicture(const CommonOptions& common, const Output& output, int width, int height,
                const std::string& what);

/// Why --json cannot go with an output to standard output.
inline constexpr const char* jsonInTheWay = "--json: standard output is taken by -o -";

/// Throws UsageError when an output is one of the files that are read, when two outputs are the same file, or when
/// one exists and `noClobber`; Error when one cannot be written.
void checkOutputs(const std::vector<std::filesystem::path>& inputs, std::span<const Output> outputs,
                  bool noClobber);

}  // namespace anamorph
