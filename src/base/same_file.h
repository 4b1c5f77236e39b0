// Whether two names mean one file: written in another way, through links, or by a second name of the same file. What is
// about to be written is compared by it with what is read.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace anamorph {

/// Whether writing to `a` would replace what is read from `b`, or the other way round. Files that are not there yet
/// are compared by the place where they would be. Devices and pipes hold nothing: false for them.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

/// The first of the files that is the same as `file`; nothing when none is.
std::optional<std::filesystem::path> findSameFile(const std::filesystem::path& file,
                                                  const std::vector<std::filesystem::path>& files);

}  // namespace anamorph
