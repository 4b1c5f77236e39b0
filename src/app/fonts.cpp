#include "app/fonts.h"

#include <algorithm>
#include <optional>

#include <imgui.h>
#include <imgui_internal.h>

#include "app/scripts.h"
#include "base/language.h"

namespace anamorph {
namespace {

// Latin with accents, Greek (angles), punctuation, arrows, signs of mathematics, geometric shapes.
constexpr ImWchar ranges[] = {0x20,   0x17f,  0x370,  0x3ff,  0x2000, 0x206f, 0x2190,
                              0x21ff, 0x2200, 0x22ff, 0x25a0, 0x25ff, 0};

constexpr ImWchar fewRanges[] = {0x20,   0x17f,  0x391,  0x3c9,  0x2010, 0x2026,
                                 0x2212, 0x2212, 0x25af, 0x25af, 0};
constexpr ImWchar missingLetter = 0x25af;  // a small empty frame
constexpr std::size_t mostLetters =
    3000;  // beyond what is always there; the texture has to fit the graphics card

bool isAlwaysThere(ImWchar letter) {
  for (const ImWchar* range = ranges; range[0]; range += 2) {
    if (letter >= range[0] && letter <= range[1]) return true;
  }
  return letter < ranges[0];
}

// Without those that need shaping, and no more than fit.
Letters drawableOf(const Letters& letters) {
  Letters drawable;
  for (const char32_t letter : letters) {
    if (!findShapedScript(letter) && drawable.size() < mostLetters) drawable.insert(letter);
  }
  return drawable;
}

// Dear ImGui's list of first and last letters, which has to live until the fonts are built.
std::vector<ImWchar> rangesOf(const Letters& letters) {
  std::vector<ImWchar> list;
  for (const char32_t letter : letters) {
    const auto code = static_cast<ImWchar>(letter);
    list.insert(list.end(), {code, code});
  }
  list.push_back(0);
  return list;
}

// Fonts with letters of other files in them.
class FontMaker {
 public:
  FontMaker(const Letters& letters, const std::optional<std::string>& regular)
      : files_(findFontsFor(drawableOf(letters))), regular_(regular.value_or("")) {
    for (const FontFile& file : files_) ranges_.push_back(rangesOf(file.letters));
  }

  ImFont* add(const std::optional<std::string>& file, double pixels, const ImWchar* glyphs = ranges) const {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    const auto size = static_cast<float>(pixels);
    ImFontConfig config;
    config.SizePixels = size;
    ImFont* const font =
        file ? atlas.AddFontFromFileTTF(file->c_str(), size, nullptr, glyphs) : atlas.AddFontDefault(&config);
    font->FallbackChar = missingLetter;
    config.MergeMode = true;
    config.OversampleH = 1;
    for (std::size_t i = 0; i < files_.size(); ++i) {
      config.FontNo = files_[i].index & 0xffff;  // above are the instances of a variable font
      const std::string& path =
          file && files_[i].path == regular_ ? *file : files_[i].path;  // bold among bold
      atlas.AddFontFromFileTTF(path.c_str(), size, &config, ranges_[i].data());
    }
    return font;
  }

 private:
  std::vector<FontFile> files_;
  std::string regular_;  // DejaVu Sans; empty: it is not there
  std::vector<std::vector<ImWchar>> ranges_;
};

}  // namespace

void addLetters(std::string_view text, Letters& letters) {
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at != end;) {
    if (static_cast<unsigned char>(*at) < 0x80) {
      ++at;
      continue;
    }
    unsigned int letter = 0;
    at += std::max(1, ImTextCharFromUtf8(&letter, at, end));
    if (letter != IM_UNICODE_CODEPOINT_INVALID && !isAlwaysThere(static_cast<ImWchar>(letter)))
      letters.insert(letter);
  }
}

Fonts loadFonts(double pixels, bool huge, const Letters& letters) {
  static const std::optional<std::string> regular = findFont("DejaVu Sans", false),
                                          bold = findFont("DejaVu Sans", true);
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  const FontMaker maker(letters, regular);
  Fonts fonts;
  fonts.text = maker.add(regular, pixels);
  if (!regular) {
    fonts.huge = huge ? fonts.text : nullptr;
  } else {
    fonts.strong = maker.add(bold ? bold : regular, pixels);
    fonts.title = maker.add(bold ? bold : regular, 1.25 * pixels);
    if (huge) fonts.huge = maker.add(regular, 1.75 * pixels, fewRanges);
  }
  atlas.Build();
  return fonts;
}

std::vector<std::string> explainMissing(const Letters& letters) {
  std::vector<std::string> sentences;
  const auto say = [&](const std::string& sentence) {
    if (std::find(sentences.begin(), sentences.end(), sentence) == sentences.end())
      sentences.push_back(sentence);
  };
  for (const char32_t letter : letters) {
    if (const char* script = findShapedScript(letter))
      say(trFormat("This text needs {} letters, which this program cannot draw.", tr(script)));
  }
  std::size_t found = 0;
  const Letters drawable = drawableOf(letters);
  const auto shaped = std::count_if(letters.begin(), letters.end(), findShapedScript);
  if (letters.size() - static_cast<std::size_t>(shaped) > drawable.size())
    say(trFormat("This text needs more than {} different letters; for the others there are empty frames.",
                 mostLetters));
  for (const FontFile& file : findFontsFor(drawable)) found += file.letters.size();
  if (found < drawable.size())
    say(tr("This text needs letters that no font of this computer has; install a font for its language."));
  return sentences;
}

}  // namespace anamorph
