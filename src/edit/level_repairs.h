// What the buttons below an error message do: a level like this one without the fault, as near to it as is
// sensible. A level that has not got the fault, or that cannot be helped, stays the same.
//
//      eye inside the mirror:                      original before the mirror:
//          .-----.                                       line of sight
//         (   e--->)-- radius --> eye              eye -----[box]----)-------> [box]
//          `-----'                                                mirror
#pragma once

#include "level/level.h"
#include "math/box.h"
#include "pipeline/memo.h"

namespace anamorph {

/// The eye just outside the mirror, about a radius from its surface: the way it is nearest, but on the side
/// away from the placed original's box (may be empty), whose reflection is wanted. findEyeProblem() finds
/// nothing afterwards unless the mirror reaches beyond the coordinates of a level.
Level eyeMovedOutside(const Level& level, const Box& originalBox);

/// The original farther along the ray from the eye through its middle (where that misses the mirror: through
/// the mirror's middle) until its whole box is behind the mirror as seen from the eye.
Level originalMovedBehind(const Level& level, const Box& originalBox);

/// Which of them there are for a level, kept as long as that stays the same: both are searches.
struct Repairs {
  Level eyeOutside;      ///< the level itself: there is none
  bool isBehind = true;  ///< the original is behind the mirror, or cannot be put there
};
class RepairsStage {
 public:
  const Repairs& at(const Level& level, const Box& originalBox);

 private:
  struct Input {
    Level level;
    Box originalBox;
    bool operator==(const Input&) const = default;
  };
  Memo<Input, Repairs> memo_;
};

}  // namespace anamorph
