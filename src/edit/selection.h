// What the user has selected: one thing of the level that can be moved, or nothing.
#pragma once

namespace anamorph {

enum class Part {
  none,
  eye,  ///< the RT camera's place
  aim,  ///< the point that the RT camera looks at
  original,
  mirror,
  sculpture,     ///< its scale is the depth scale
  controlPoint,  ///< of the mirror: number `index`
  light,         ///< the level's light number `index`
};

struct Selection {
  Part part = Part::none;
  int index = 0;  ///< of a light, of a control point

  bool operator==(const Selection&) const = default;
};

/// Whether it is the mirror, or a control point of it.
constexpr bool isOfMirror(const Selection& selection) {
  return selection.part == Part::mirror || selection.part == Part::controlPoint;
}

}  // namespace anamorph
