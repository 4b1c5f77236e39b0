// The surfaces a mirror can have: a quad of a plane, a finite cylinder (an open tube), a sphere. For a ray
// each tells the first point where it meets the finite surface, and the normal there. Both sides reflect.
//
// To add a shape: a struct here and its name in the variant; intersect and shapeName (mirror_shapes.cpp),
// what can be wrong with it (mirror_problems.cpp), its triangles (tessellate.cpp), its fields in a level
// (../level/level_fields.h) and the distance to its border for the bright rim (../raytrace/shading.cpp): the
// compiler asks for each. A batch form in exit_points.cpp only when it should be faster than one ray after
// the other.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "geometry/mesh.h"
#include "math/ray.h"

namespace anamorph {

/// A planar convex quadrilateral, corners in order around it.
struct PlaneMirror {
  std::array<Point, 4> corners{Point(-1, 0, -1), Point(1, 0, -1), Point(1, 0, 1), Point(-1, 0, 1)};
  bool operator==(const PlaneMirror&) const = default;
};

/// The side of a cylinder between two centres; open at both ends.
struct CylinderMirror {
  Point bottom{0, 0, 0};
  Point top{0, 0, 1};
  double radius = 1;
  bool operator==(const CylinderMirror&) const = default;
};

struct SphereMirror {
  Point centre{0};
  double radius = 1;
  bool operator==(const SphereMirror&) const = default;
};

using MirrorShape = std::variant<PlaneMirror, CylinderMirror, SphereMirror>;

struct SurfaceHit {
  double t = 0;         ///< along the ray, in lengths of its direction
  Point point{0};       ///< on the surface
  Direction normal{0};  ///< towards the ray's origin: dot(normal, direction) <= 0
};

/// The first hit at t > tMin; nothing when the ray misses.
std::optional<SurfaceHit> intersect(const PlaneMirror& plane, const Ray& ray, double tMin = 0);
std::optional<SurfaceHit> intersect(const CylinderMirror& cylinder, const Ray& ray, double tMin = 0);
std::optional<SurfaceHit> intersect(const SphereMirror& sphere, const Ray& ray, double tMin = 0);
std::optional<SurfaceHit> intersect(const MirrorShape& shape, const Ray& ray, double tMin = 0);

/// What is wrong with the shape itself (a quad that is not planar, a radius that is not > 0), in a sentence;
/// nothing when it is sound.
std::optional<std::string> findShapeProblem(const MirrorShape& shape);

/// Why no anamorphosis can be made of a sound shape from this eye, in a sentence a student understands and
/// with what to do about it; nothing when it can.
std::optional<std::string> findEyeProblem(const MirrorShape& shape, const Point& eye);

/// What the shape is called in files and messages: "plane", "cylinder", "sphere".
const char* shapeName(const MirrorShape& shape);

/// The plane's unit normal; undefined for a quad without area.
Direction planeNormal(const PlaneMirror& plane);

/// The middle of the four corners; of the cylinder's axis; the sphere's centre.
Point middleOf(const PlaneMirror& plane);
Point middleOf(const CylinderMirror& cylinder);
Point middleOf(const SphereMirror& sphere);
Point middleOf(const MirrorShape& shape);

/// The surface as triangles, for drawing and boxes; vertices lie on the surface. Curved shapes get `segments`
/// around.
Mesh tessellate(const MirrorShape& shape, int segments = 96);

}  // namespace anamorph
