// Where the panels are: a fixed arrangement with splitters. In small windows the side panels give way, and go
// when that is not enough, so that the 3D view always has room. While a lesson runs the level list is folded to
// one line where the lesson needs its room; a low window shows the lesson without it.
//
//   +----------------------------------------------+
//   | menu                                         |
//   +--------+----------------------+--------------+
//   | levels |                      | properties   |
//   |        |       3D view        |              |
//   +--------+                      +--------------+
//   | lesson |                      | preview      |
//   +--------+----------------------+--------------+
//   | status                                       |
//   +----------------------------------------------+
//
// For an audience there are the view, the preview beside it, and a strip below both for the words. All borders are at
// whole pixels, so that nothing shines through between two panels.
#pragma once

namespace anamorph {

/// Of a row of the level list, at scale 1.
constexpr float levelRowHeight = 40;

/// Widths of the side panels that can still be read, at scale 1.
constexpr float smallestLeft = 180, smallestRight = 240;

/// Pixels, origin top-left.
struct Rect {
  float x = 0, y = 0, width = 0, height = 0;

  bool empty() const { return !(width > 0 && height > 0); }
  bool contains(float px, float py) const { return px >= x && py >= y && px < x + width && py < y + height; }
  bool operator==(const Rect&) const = default;
};

/// Panels that are not shown have an empty rectangle.
struct Layout {
  Rect menu, left, lesson, view, properties, preview, status;
  Rect words;                 ///< of the open step, for an audience
  bool levelsFolded = false;  ///< the level list is one line, its heading

  bool operator==(const Layout&) const = default;
};

struct LayoutInput {
  float width = 0, height = 0;  ///< of the window, pixels
  float scale = 1;
  float leftWidth = 0, rightWidth = 0, previewHeight = 0;  ///< at scale 1
  bool panelsHidden = false;
  bool presenting = false;       ///< hidden panels leave the preview
  bool previewExpanded = false;  ///< the preview takes half of the window
  int levels = 0;                ///< rows of the level list
  bool lessonRuns = false;
  bool levelsOpen = false;  ///< the list was unfolded by hand
  float wordsHeight = 0;    ///< pixels that the words for an audience need; 0: there are none
};

Layout makeLayout(const LayoutInput& input);

/// The largest scale, up to the wanted one, at which a window of this size (pixels) has room for all panels; at 100 %,
/// or the wanted scale if that is less, it is the panels that give way.
double fittingScale(double wanted, double width, double height);

}  // namespace anamorph
