// What is in a folder, as a person wants to see it; folders are made here, too.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace anamorph {

struct FolderEntry {
  std::string name;
  bool isFolder = false;

  bool operator==(const FolderEntry&) const = default;
};

struct FolderListing {
  std::vector<FolderEntry>
      entries;          ///< folders first, by name: 2 before 10, capital letters among small ones
  std::string problem;  ///< why it cannot be listed; empty when all is well
};

/// Files and folders; of links what they lead to. Never throws.
FolderListing listFolder(const std::filesystem::path& folder);

/// The order of names in a listing.
bool comesBefore(const std::string& a, const std::string& b);

/// Makes the folder, and those above it, where there are none; what was made outlives a power cut. Throws Error.
void makeFolder(const std::filesystem::path& folder);

/// From its return on what was made, renamed and removed in the folder (an empty path: the working folder) outlives a
/// power cut. False, and errno, when the disk does not take it. A folder that cannot be flushed by its nature (one that
/// may not be read, some network file systems) is no fault.
[[nodiscard]] bool syncFolder(const std::filesystem::path& folder);

/// What the links that end in this name lead to, if only to a name that is not there yet; in a ring of links, one of them.
std::filesystem::path behindLinks(std::filesystem::path path);

/// For messages about what is no file: "a folder", "a link", "a pipe", "a socket" or "a device".
std::string kindName(std::filesystem::file_type type);

/// $HOME, else the root.
std::filesystem::path homeFolder();

/// ASCII capitals as small letters; others stay.
std::string lowerCase(std::string text);

/// What a name ends in, in small letters: ".png" of "A.PNG"; empty for a name without a dot.
std::string lowerEnding(const std::filesystem::path& path);

}  // namespace anamorph
