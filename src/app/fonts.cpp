#include "app/fonts.h"

#include <optional>
#include <string>

#include <fontconfig/fontconfig.h>
#include <imgui.h>

namespace anamorph {
namespace {

// Latin with accents, Greek (angles), punctuation, arrows, signs of mathematics, geometric shapes.
constexpr ImWchar ranges[] = {0x20,   0x17f,  0x370,  0x3ff,  0x2000, 0x206f, 0x2190,
                              0x21ff, 0x2200, 0x22ff, 0x25a0, 0x25ff, 0};

constexpr ImWchar fewRanges[] = {0x20, 0x17f, 0x391, 0x3c9, 0x2010, 0x2026, 0x2212, 0x2212, 0};

// The file of a font of exactly this family; fontconfig always offers something, which may lack what is
// needed.
std::optional<std::string> findFont(const char* family, bool bold) {
  FcPattern* pattern = FcPatternCreate();
  FcPatternAddString(pattern, FC_FAMILY, reinterpret_cast<const FcChar8*>(family));
  FcPatternAddInteger(pattern, FC_WEIGHT, bold ? FC_WEIGHT_BOLD : FC_WEIGHT_REGULAR);
  FcPatternAddInteger(pattern, FC_SLANT, FC_SLANT_ROMAN);
  FcConfigSubstitute(nullptr, pattern, FcMatchPattern);
  FcDefaultSubstitute(pattern);
  FcResult result = FcResultNoMatch;
  FcPattern* match = FcFontMatch(nullptr, pattern, &result);
  std::optional<std::string> file;
  FcChar8 *path = nullptr, *found = nullptr;
  if (match && FcPatternGetString(match, FC_FILE, 0, &path) == FcResultMatch &&
      FcPatternGetString(match, FC_FAMILY, 0, &found) == FcResultMatch &&
      std::string(reinterpret_cast<const char*>(found)) == family) {
    file = reinterpret_cast<const char*>(path);
  }
  if (match) FcPatternDestroy(match);
  FcPatternDestroy(pattern);
  return file;
}

ImFont* addFont(const std::optional<std::string>& file, double pixels, const ImWchar* glyphs = ranges) {
  if (!file) return nullptr;
  return ImGui::GetIO().Fonts->AddFontFromFileTTF(file->c_str(), static_cast<float>(pixels), nullptr, glyphs);
}

}  // namespace

Fonts loadFonts(double pixels, bool huge) {
  static const std::optional<std::string> regular = findFont("DejaVu Sans", false),
                                          bold = findFont("DejaVu Sans", true);
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  Fonts fonts;
  fonts.text = addFont(regular, pixels);
  fonts.strong = addFont(bold ? bold : regular, pixels);
  fonts.title = addFont(bold ? bold : regular, 1.25 * pixels);
  if (!fonts.text) {
    ImFontConfig config;
    config.SizePixels = static_cast<float>(pixels);
    fonts.text = atlas.AddFontDefault(&config);
    fonts.huge = huge ? fonts.text : nullptr;
    return fonts;
  }
  if (huge) fonts.huge = addFont(regular, 1.75 * pixels, fewRanges);
  return fonts;
}

}  // namespace anamorph
