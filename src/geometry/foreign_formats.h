// Files that are no OBJ, STL or PLY: other programs' models, pictures, archives, web pages saved in a model's place.
// One table of what they end in and begin with, to say what a file is and what to do about it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace anamorph {

struct ForeignFormat {
  std::string_view name;                  ///< "STEP"
  std::string_view what;                  ///< "a STEP file"
  std::string_view advice;                ///< "export it as STL or OBJ"
  std::vector<std::string_view> endings;  ///< in small letters, with their dot
  std::vector<std::string_view>
      beginnings;  ///< of its bytes; one with < may stand anywhere near the begin of markup
};

/// The format whose ending the name has; null for another.
const ForeignFormat* foreignByEnding(const std::filesystem::path& path);

/// The format that the first bytes of a file are of; null for another. `head` is at least the first 2 KiB, or all.
const ForeignFormat* foreignByContent(std::string_view head);

}  // namespace anamorph
