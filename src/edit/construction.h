// The construction of one vertex of the sculpture, ready to be drawn and read: the vertex ray (vertex_ray.h)
// with its letters, both equal angles at Q, and all numbers as text.
//
//            P
//             \  d                    incident  E - Q      virtual    Q - P, behind the mirror
//      --------Q-------- mirror       reflected Q - S      normal     at Q, towards the eye
//        E __/a|a\                    two arcs a between the rays and the normal
//              N   \ S
//
// Without a mirror there is one straight line, E - Q - P with S on it. With the published mistakes the rays
// and angles are the published ones: that the two angles differ is seen.
//
// A vertex that is not mapped has what there is of it, and a sentence that says what became of its ray.
#pragma once

#include <string>
#include <vector>

#include "anamorphosis/vertex_ray.h"

namespace anamorph {

struct ConstructionLabel {
  Point at{0};
  std::string text;
};

struct ConstructionSegment {
  enum class Kind { incident, virtualRay, reflected, normal };

  Point from{0}, to{0};
  Kind kind = Kind::incident;
};

/// An arc about Q in the plane of incidence, with a place for its label.
struct ConstructionArc {
  std::vector<Point> points;
  ConstructionLabel label;
};

/// A line of the panel.
struct ConstructionRow {
  std::string name, value;
};

struct Construction {
  VertexRay ray;
  std::vector<ConstructionLabel> points;     ///< E, P, Q, N (the normal's tip), S
  std::vector<ConstructionLabel> distances;  ///< "d = 3.41" at the middle of Q-P, "k·d = 1.36" at that of Q-S
  std::vector<ConstructionSegment> segments;
  std::vector<ConstructionArc> arcs;
  std::vector<ConstructionRow> rows;
  std::string explanation;  ///< for a student, when the vertex is not mapped; else empty
};

/// Everything finite, whatever became of the ray.
Construction makeConstruction(const VertexMap& map, const Point& original);

}  // namespace anamorph
