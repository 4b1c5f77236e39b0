// Pictures of the window itself: as large as it is or up to four times, with or without its panels, over
// nothing on request. Drawn anew for the picture, so they are as sharp as a screen of that size.
#pragma once

#include "app/gui.h"

namespace anamorph {

/// Colours that were drawn over nothing were multiplied by alpha: undoes it.
void divideByAlpha(Bitmap& bitmap);
Bitmap withoutAlpha(const Bitmap& bitmap);

/// The GUI as it is, in its final quality. The window goes on as before with its next frame.
Bitmap takeShot(Gui& gui, const ShotRequest& request);

}  // namespace anamorph
