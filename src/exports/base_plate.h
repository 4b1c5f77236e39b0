// A base plate that the sculpture is printed with, and stands on.
//
//          ____                       It lies on the table and bears the sculpture on posts that reach a
//         /____\   sculpture          little into it. A sculpture that stands on the table itself gets
//          |  |    posts              the plate below it, let into the table.
//       ===+==+=== plate              Plate, posts and sculpture are closed shells that overlap: slicers
//     ---------------- table          unite them.
#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace anamorph {

/// In millimetres.
struct BasePlateSettings {
  double thickness = 2;
  double margin = 3;  ///< around the sculpture's footprint

  bool operator==(const BasePlateSettings&) const = default;
};

/// In the coordinates of the sculpture, millimetres.
struct BasePlate {
  Mesh mesh;                        ///< plate and posts, each a closed shell
  std::vector<glm::dvec2> outline;  ///< convex, counter-clockwise seen from above
  std::vector<glm::dvec2> posts;    ///< their middles
  double postRadius = 0;
  double lowerFace = 0;  ///< its z; below the table for a sculpture that stands on it
  double thickness = 0;
};

/// The plate for a sculpture on a table at z = `table`. Throws Error when the mirror stands where plate or
/// posts would have to.
BasePlate makeBasePlate(const Mesh& sculpture, const Mesh& mirror, double table,
                        const BasePlateSettings& settings);

/// The corners of the convex hull, counter-clockwise, from the lowest x on (Andrew 1979).
std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points);

}  // namespace anamorph
