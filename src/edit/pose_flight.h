// A smooth move of the 3D view from one pose to another: slow at both ends, and exactly at its goal when it
// ends.
//
// The target goes straight, the distance grows or shrinks by equal factors, the direction turns on the
// sphere. Between two level poses azimuth and height turn, so that the horizon stays level all the way;
// otherwise the whole picture turns about one axis.
#pragma once

#include "edit/view_pose.h"

namespace anamorph {

struct PoseFlight {
  ViewPose from;
  ViewPose goal;
  double duration = 0.2;  ///< seconds

  /// The pose so many seconds after the start; before it `from`, from the end on `goal`, both to the bit.
  ViewPose poseAt(double seconds) const;
  bool endedAt(double seconds) const { return !(seconds < duration); }
};

/// A flight in the middle of which the goal changes: it goes on from where it is.
PoseFlight retargeted(const PoseFlight& flight, double seconds, const ViewPose& goal);

}  // namespace anamorph
