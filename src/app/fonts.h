// The window's fonts: DejaVu Sans, which has the signs of geometry, and for letters that it lacks whatever font of this
// computer has them, all found by fontconfig. Without DejaVu Dear ImGui's own pixel font serves. Which letters texts need
// is asked for in every frame (that is quick); the fonts are loaded anew only when one of them is not there yet.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/font_files.h"
#include "panels/look.h"

namespace anamorph {

/// Adds the letters of a text that are not in the fonts anyway. What is not UTF-8 is left out.
void addLetters(std::string_view text, Letters& letters);

/// Puts the fonts into the current Dear ImGui context, `pixels` high, with these letters as far as they can be drawn: no
/// more than 3000, none of a script that needs shaping (scripts.h), none that no font has. In the place of others is a
/// small empty frame. The huge font only when asked for, because its letters take much room. The caller makes the texture.
Fonts loadFonts(double pixels, bool huge, const Letters& letters);

/// What is to be said about those of the letters that cannot be drawn: a sentence for each script, one for all letters
/// that no font has, one when they are too many.
std::vector<std::string> explainMissing(const Letters& letters);

}  // namespace anamorph
