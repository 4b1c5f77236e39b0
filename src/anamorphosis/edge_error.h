// How far, in pixels of the RT camera's image, is a straight edge of the sculpture from the curve it stands
// for?
//
//      original          sculpture
//      a-----m-----b     A         B      M = (A + B) / 2 is on the edge, S = map(m) is where it should be.
//                         \__ S __/       The gap M - S is expressed in the map's own derivatives,
//                             M           M - S = x dS/dx + y dS/dy + w R : x and y shift the image,
//                                         w only moves along the reflected ray and is not seen.
//
// dS/dx, dS/dy are finite differences of the exact map, so any optic will do (method section 5, fact F8).
#pragma once

#include "anamorphosis/vertex_map.h"
#include "optics/camera.h"

namespace anamorph {

struct EdgeJudge {
  const VertexMap& map;
  const Projection& projection;
};

struct EdgeEnd {
  Point original;
  Point sculpture;
  PathStatus status;
};

/// The largest error in pixels over the points of the edge that are looked at: the middle, and the quarters
/// when the edge is long in the image. An edge that is mapped only in part counts its length in the image (it
/// is to be split until the border is known to a pixel), one that is not mapped at all counts 0.
double edgeErrorPixels(const EdgeJudge& judge, const EdgeEnd& a, const EdgeEnd& b);

}  // namespace anamorph
