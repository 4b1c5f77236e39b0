// Pictures of the window itself: as large as it is or up to four times, with or without its panels, over
// nothing on request. Drawn anew for the picture, so they are as sharp as a screen of that size. The panels are drawn
// at once; the 3D view takes its time, and the window goes on meanwhile.
#pragma once

#include "app/gui.h"

namespace anamorph {

/// Colours that were drawn over nothing were multiplied by alpha: undoes it.
void divideByAlpha(Bitmap& bitmap);
Bitmap withoutAlpha(const Bitmap& bitmap);

/// Both parts of a picture, RGBA: the panels' colours multiplied by alpha, the view's not.
struct ShotLayers {
  Bitmap panels, view;
  int viewX = 0, viewY = 0;  ///< of its upper left corner
  bool transparent = false;
};

/// The panels over the view.
Bitmap compose(const ShotLayers& layers);

class Shot {
 public:
  /// Of the window as it is. Throws Error when it is too large for the graphics card.
  Shot(Gui& gui, const ShotRequest& request);

  /// Goes on for about so many milliseconds.
  void draw(double milliseconds);
  bool complete() const { return viewport_.complete(); }
  /// How far it is, 0..1.
  double fraction() const { return viewport_.fraction(); }

  /// Once it is complete.
  ShotLayers takeLayers();

 private:
  ShotLayers layers_;  // but for the view
  ViewportInput input_;
  int samples_ = 1;
  Viewport viewport_;
};

}  // namespace anamorph
