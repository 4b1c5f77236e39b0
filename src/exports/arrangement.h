// A finished level as it is set up on a table: every length in millimetres, heights above the table, and the
// directions as the viewer has them.
//
//              away             The viewer stands at the foot of the eye and looks to the middle of the
//               |               mirror: `away` is that direction on the table, `right` is to the right of it.
//           ----+---- mirror    A point's plan is (right, away) from below the mirror's middle, its side view
//               |               (away, height above the table).
//              eye ---> right
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exports/base_plate.h"
#include "pipeline/picture.h"

namespace anamorph {

using Point2 = glm::dvec2;

struct Arrangement {
  std::string title;
  double millimetresPerUnit = 1;
  bool hasMirror = true;  ///< else `mirror` is a canvas that is only thought of, and nothing stands there
  Shape mirror;
  Mesh mirrorSurface;  ///< the mirror as triangles
  Mesh sculpture;      ///< as it is printed
  std::optional<BasePlate> plate;
  Point eye{0};
  Point middle{0};  ///< of the mirror
  Point2 away{0, 1};
  Point2 right{1, 0};
  double table = 0;      ///< its z
  bool onGround = true;  ///< the table is the level's ground; else it is lower, where mirror or sculpture end

  /// (right, away) of a point, from below the mirror's middle.
  Point2 planOf(const Point& p) const;
  /// (away, height above the table).
  Point2 sideOf(const Point& p) const;
};

/// Throws Error when the lengths become too large, or when no base plate can be made.
Arrangement makeArrangement(const LevelResult& finished, double millimetresPerUnit,
                            const std::optional<BasePlateSettings>& plate = {});

/// The base plate in scene units; null without one.
std::shared_ptr<const Bvh> plateInScene(const Arrangement& arrangement);

/// The share of the image's pixels with a reflection of the sculpture that the base plate hides, seen by the
/// RT camera: it stands before the mirror, or between mirror and sculpture. 0 without a plate.
double fractionHiddenByPlate(const LevelResult& finished, const Arrangement& arrangement);

/// How the eye sees the sculpture along a ray: by way of the mirror, or straight.
struct Sight {
  std::vector<Point> points;  ///< from the eye by way of the mirror, if any, to the sculpture
  Ray last;                   ///< the ray that meets the sculpture
  double t = 0;               ///< and where it does
};

/// Nothing where the ray does not end on the sculpture, or where that stands before the mirror.
std::optional<Sight> findSight(const LevelResult& finished, const Ray& ray);

/// In millimetres.
Shape scaleMirror(const Shape& shape, double factor);

}  // namespace anamorph
