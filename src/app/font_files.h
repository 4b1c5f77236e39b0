// The font files of this computer, as fontconfig knows them.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace anamorph {

using Letters = std::set<char32_t>;

/// A font that Dear ImGui can read, and letters that it has.
struct FontFile {
  std::string path;
  int index = 0;  ///< in a file of several fonts
  Letters letters;
};

/// The file of a font of exactly this family; fontconfig always offers something, which may lack what is needed.
std::optional<std::string> findFont(const char* family, bool bold);

/// Fonts that have the letters, each of these in the first one that has it: DejaVu Sans, then others in the order that
/// the computer prefers. What no font has is in none.
std::vector<FontFile> findFontsFor(const Letters& letters);

}  // namespace anamorph
