// The construction for one vertex (method section 2): eye E, original vertex P, mirror point Q, sculpture
// vertex S.
//
//         P (behind the mirror)          S = Q + d R,   d = k |P - Q|
//          \   d/k
//     ------Q-------- mirror             The depth scale k only says how far out the sculpture reaches:
//          / \ d                         any d > 0 is seen at the same place of the image (fact F1). An offset
//         E   S                          may be added to it, to come beyond a focus.
#pragma once

#include <vector>

#include "anamorphosis/vertex_map.h"

namespace anamorph {

/// A leg of a vertex ray: from where it meets the optic on to the next meeting, or to the end.
struct VertexLeg {
  Point start{0};                                  ///< Q
  Direction normal{0};                             ///< N there, towards the incoming ray
  Direction direction{0};                          ///< R, unit
  double angleInDegrees = 0, angleOutDegrees = 0;  ///< of both rays with the normal
};

struct VertexRay {
  Point eye{0};                 ///< E
  Point original{0};            ///< P
  std::vector<VertexLeg> legs;  ///< after the one from the eye, in order; empty: it misses
  bool bends = false;           ///< whether the optic changes its direction
  Point sculpture{0};           ///< S; the original's point unless mapped
  PathStatus status = PathStatus::missesMirror;
  double distance = 0;  ///< |P - Q|; beyond several points the rest of the way (method-optics section 2)
  double reach = 0;     ///< offset + k distance: how far S is from the last Q

  bool meets() const { return !legs.empty(); }
  bool mapped() const { return status == PathStatus::mapped; }
};

/// The vertex ray of `original` with everything that a student is shown of it. With mistakes: what the published
/// formulas make of it.
VertexRay makeVertexRay(const VertexMap& map, const Point& original);

}  // namespace anamorph
