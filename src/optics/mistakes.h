// The three mistakes in the formulas of the thesis' published program, as switches: so that a student can see
// what each does and put it right (method section 3). Nothing else in the program is wrong with them; the
// match report, which does not know how a sculpture was made, is the judge.
//
//   right                          published
//   R = D - 2 (D.N) N              -R: the ray towards the eye is reflected, not the one away from it
//   d = |P - Q|                    |(P - E) - Q|: a point is taken from a direction
//   N through a cylinder's axis    N through a cylinder's middle, as if it were a sphere
#pragma once

#include <string_view>

namespace anamorph {

/// True: as published.
struct Mistakes {
  bool direction = false;
  bool distance = false;
  bool normal = false;  ///< makes a difference for cylinders only

  bool any() const { return direction || distance || normal; }
  bool operator==(const Mistakes&) const = default;
};

/// By its member's name, as lessons have it.
inline bool& mistakeOf(Mistakes& mistakes, std::string_view name) {
  if (name == "direction") return mistakes.direction;
  return name == "distance" ? mistakes.distance : mistakes.normal;
}

}  // namespace anamorph
