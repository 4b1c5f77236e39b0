// How the panels look: colours, spacing and sizes of the three themes. Readable first.
#pragma once

#include <optional>

#include <imgui.h>

#include "math/palette.h"
#include "optics/material.h"
#include "panels/look.h"

namespace anamorph {

/// Sets Dear ImGui's style for a theme and a scale.
void applyStyle(Theme theme, double scale);

/// Factor of the size of everything: the projector theme's is larger.
double themeScale(Theme theme);

/// The 3D view's sky for a theme; dark shows the level's own.
std::optional<Background> skyOf(Theme theme);

/// Colours with a meaning, the same in every theme where they are readable there.
namespace ink {
/// As Dear ImGui draws it; `alpha`: 0..255.
constexpr ImU32 of(Rgb color, int alpha = 255) {
  return IM_COL32(channelOf(color, 0), channelOf(color, 1), channelOf(color, 2), alpha);
}
ImVec4 good(Theme theme);      ///< excellent, matched
ImVec4 middling(Theme theme);  ///< partial
ImVec4 bad(Theme theme);       ///< none; what is wrong
ImVec4 accent(Theme theme);
ImVec4 quiet(Theme theme);  ///< text of second rank
}  // namespace ink

/// Text in a font, for as long as it lives.
class FontScope {
 public:
  explicit FontScope(ImFont* font) : pushed_(font != nullptr) {
    if (pushed_) ImGui::PushFont(font);
  }
  ~FontScope() {
    if (pushed_) ImGui::PopFont();
  }
  FontScope(const FontScope&) = delete;
  FontScope& operator=(const FontScope&) = delete;

 private:
  bool pushed_;
};

}  // namespace anamorph
