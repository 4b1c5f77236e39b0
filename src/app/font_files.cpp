#include "app/font_files.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <string_view>
#include <utility>

#include <fontconfig/fontconfig.h>

namespace anamorph {
namespace {

template <auto destroy>
struct Destroyer {
  template <typename T>
  void operator()(T* object) const {
    destroy(object);
  }
};
using Pattern = std::unique_ptr<FcPattern, Destroyer<FcPatternDestroy>>;
using FontSet = std::unique_ptr<FcFontSet, Destroyer<FcFontSetDestroy>>;

Pattern completed(Pattern pattern) {
  FcConfigSubstitute(nullptr, pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  return pattern;
}

std::string textOf(const FcPattern* font, const char* property) {
  FcChar8* text = nullptr;
  return FcPatternGetString(font, property, 0, &text) == FcResultMatch ? reinterpret_cast<const char*>(text)
                                                                       : "";
}

bool isSet(const FcPattern* font, const char* property) {
  FcBool value = FcFalse;
  return FcPatternGetBool(font, property, 0, &value) == FcResultMatch && value;
}

// As the first bytes of the file say, which is not there any more perhaps, or is packed (WOFF): fontconfig calls that
// TrueType, too.
bool beginsAsFont(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string begin(4, 0);
  file.read(begin.data(), 4);
  constexpr std::string_view known[] = {{"\0\1\0\0", 4}, "true", "OTTO", "ttcf"};
  return file && std::find(std::begin(known), std::end(known), begin) != std::end(known);
}

// Dear ImGui reads outlines of TrueType and PostScript; it would end the program at others.
bool isReadable(const FcPattern* font) {
  const std::string format = textOf(font, FC_FONTFORMAT);
  return (format == "TrueType" || format == "CFF") && isSet(font, FC_SCALABLE) && !isSet(font, FC_COLOR) &&
         !isSet(font, FC_VARIABLE) && beginsAsFont(textOf(font, FC_FILE));
}

// Those of the letters that the font has leave `left`.
Letters takeLetters(const FcPattern* font, Letters& left) {
  Letters taken;
  FcCharSet* has = nullptr;
  if (FcPatternGetCharSet(font, FC_CHARSET, 0, &has) != FcResultMatch) return taken;
  for (auto letter = left.begin(); letter != left.end();) {
    if (FcCharSetHasChar(has, *letter)) {
      taken.insert(*letter);
      letter = left.erase(letter);
    } else {
      ++letter;
    }
  }
  return taken;
}

}  // namespace

std::optional<std::string> findFont(const char* family, bool bold) {
  Pattern pattern(FcPatternCreate());
  FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family));
  FcPatternAddInteger(pattern.get(), FC_WEIGHT, bold ? FC_WEIGHT_BOLD : FC_WEIGHT_REGULAR);
  FcPatternAddInteger(pattern.get(), FC_SLANT, FC_SLANT_ROMAN);
  pattern = completed(std::move(pattern));
  FcResult result = FcResultNoMatch;
  const Pattern match(FcFontMatch(nullptr, pattern.get(), &result));
  if (!match || textOf(match.get(), FC_FAMILY) != family) return std::nullopt;
  const std::string file = textOf(match.get(), FC_FILE);
  return file.empty() ? std::nullopt : std::optional(file);
}

std::vector<FontFile> findFontsFor(const Letters& letters) {
  std::vector<FontFile> files;
  Letters left = letters;
  if (left.empty()) return files;
  Pattern pattern(FcPatternCreate());
  FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("DejaVu Sans"));
  pattern = completed(std::move(pattern));
  FcResult result = FcResultNoMatch;
  const FontSet sorted(FcFontSort(nullptr, pattern.get(), FcFalse, nullptr, &result));
  for (int i = 0; sorted && i < sorted->nfont && !left.empty(); ++i) {
    const FcPattern* font = sorted->fonts[i];
    if (!isReadable(font)) continue;
    FontFile file{textOf(font, FC_FILE), 0, takeLetters(font, left)};
    FcPatternGetInteger(font, FC_INDEX, 0, &file.index);
    if (!file.letters.empty()) files.push_back(std::move(file));
  }
  return files;
}

}  // namespace anamorph
