// Texts of lessons and levels, which may be as long as their authors like: wrapped once for a font and a width, and only
// the lines that are in sight are drawn. Dear ImGui alone would measure all of it in every frame, and ends the program
// when more than 16384 letters are drawn at once.
#pragma once

#include <cstddef>
#include <list>
#include <string>
#include <string_view>
#include <vector>

struct ImFont;

namespace anamorph {

/// The last few texts, wrapped.
class LongTexts {
 public:
  /// The text in the chosen language, wrapped at the right edge of the window, in the current font and colour; numbers
  /// stay with their percent sign.
  void draw(const std::string& english);

  /// How many lines have been measured so far (grows only when a text, a font or a width is a new one), and drawn.
  std::size_t measured() const { return measured_; }
  std::size_t drawn() const { return drawn_; }

 private:
  struct Layout {
    std::string source, text;
    const ImFont* font;
    float size, width;
    std::vector<std::string_view> lines;  // of `text`
  };
  const Layout& layoutOf(std::string source);
  void wrap(Layout& layout);

  std::list<Layout> layouts_;  // newest use first
  std::size_t measured_ = 0, drawn_ = 0;
};

}  // namespace anamorph
