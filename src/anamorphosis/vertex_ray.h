// The construction for one vertex (method section 2): eye E, original vertex P, mirror point Q, sculpture
// vertex S.
//
//         P (behind the mirror)          S = Q + d R,   d = k |P - Q|
//          \   d/k
//     ------Q-------- mirror             The depth scale k only says how far out the sculpture reaches:
//          / \ d                         any d > 0 is seen at the same place of the image (fact F1).
//         E   S
#pragma once

#include "optics/mistakes.h"
#include "optics/optic.h"

namespace anamorph {

struct VertexRay {
  Point eye{0};            ///< E
  Point original{0};       ///< P
  Point mirror{0};         ///< Q, undefined when status is missesMirror
  Direction normal{0};     ///< N at Q, towards the eye
  Direction reflected{0};  ///< R, unit
  Point sculpture{0};      ///< S, undefined unless mapped
  PathStatus status = PathStatus::missesMirror;
  double distance = 0;      ///< |P - Q|; S is depthScale times as far from Q
  double angleDegrees = 0;  ///< of incidence, equal to that of reflection
};

/// The vertex ray of `original` with everything that a student is shown of it.
/// With mistakes: what the published formulas make of it.
VertexRay makeVertexRay(const Optic& optic, const Point& eye, const Point& original, double depthScale,
                        const Mistakes& mistakes = {});

/// Only where the vertex goes, and what became of it. Not mapped: the original point itself.
struct MappedPoint {
  Point point;
  PathStatus status;
};
MappedPoint mapPoint(const Optic& optic, const Point& eye, const Point& original, double depthScale,
                     const Mistakes& mistakes = {});

}  // namespace anamorph
