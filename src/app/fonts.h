// The window's fonts: DejaVu Sans, which has the signs of geometry, found by fontconfig. Without it Dear
// ImGui's own pixel font serves.
#pragma once

#include "panels/look.h"

namespace anamorph {

/// Puts the fonts into the current Dear ImGui context, `pixels` high; the huge one only when asked for,
/// because its letters take much room. The caller makes the texture.
Fonts loadFonts(double pixels, bool huge);

}  // namespace anamorph
