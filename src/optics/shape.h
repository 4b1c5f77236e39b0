// A surface that light meets: all that the rest of the program may ask of one. Every shape is a struct in a file
// of its own (plane.h, cylinder.h, ...) that answers these questions; Shape is a value that holds any of them.
// Outside of this room only a level's standard mirror and the scenes of the thesis name a concrete shape, and no other
// code switches over shapes.
//
//     plane.h  cylinder.h  cone.h  sphere.h  ...     one file a shape: fields, hit, normal, box, axes, words
//          \       \        /       /
//           shape_table.cpp                           their names: files, panels and lessons ask this table
//                  |
//                Shape                                level, map, tracer, edits, sheet, 3D view
//
// To add a shape: one file like cone.h, its line in shape_table.cpp, its shaders/shapes/<name>.glsl, its words in
// assets/languages, its tests. What a shape need not have (a batch form of its map, for example) is told by its
// absence: see ShapeOf (any_shape.h).
#pragma once

#include <array>
#include <concepts>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec4.hpp>

#include "base/lazy.h"
#include "geometry/smooth_mesh.h"
#include "math/box.h"
#include "math/frame.h"
#include "math/half_space.h"
#include "math/ray.h"
#include "optics/any_shape.h"

namespace anamorph {

/// A shape by value, cut off by half-spaces if it has any. Copies share what never changes, so they are cheap; equal
/// fields are equal shapes.
class Shape {
 public:
  /// The plane mirror of the first level.
  Shape();
  Shape(const Shape&) = default;  // copies only: what was moved from would be no shape
  Shape& operator=(const Shape&) = default;
  template <ConcreteShape S>
  Shape(S&& shape);  // NOLINT: a concrete shape is a shape

  bool operator==(const Shape& other) const;
  const AnyShape* operator->() const { return any_.get(); }

  /// What of the surface is kept: the points that lie in all of them.
  const std::vector<HalfSpace>& clip() const;
  void clipBy(std::vector<HalfSpace> clip);
  /// Its triangles, cut off, and their box; only of a shape that is.
  struct CutSurface {
    SmoothMesh surface;
    Box box;
  };
  const CutSurface& cutSurface() const;

  /// The concrete shape when it is an S, else null: for files that name one, and for tests.
  template <typename S>
  const S* as() const;

 private:
  friend void visitFields(Shape& shape, ShapeFields& fields);
  friend Shape mapShape(const Shape& shape, const ShapeMap& map);
  friend Shape continued(const Shape& shape);
  friend Shape withoutCutSurface(const Shape& shape);
  friend Shape withControlPointMoved(const Shape& shape, std::size_t number, const Vector& motion);
  struct Cut {
    std::vector<HalfSpace> planes;
    Lazy<CutSurface> surface{};
  };
  Shape(std::shared_ptr<const AnyShape> any, std::vector<HalfSpace> clip);

  std::shared_ptr<const AnyShape> any_;
  std::shared_ptr<const Cut> cut_;  // null: it is whole
};

/// The first hit at t > tMin; nothing when the ray misses. Both sides of a surface reflect.
std::optional<SurfaceHit> intersect(const Shape& shape, const Ray& ray, double tMin = 0);

/// Whether it meets it at tMin < t < tMax, for ends that are plainly beside the surface: quicker than to find where.
bool meetsBetween(const Shape& shape, const Ray& ray, double tMin, double tMax);

/// Whether all that this eye sees of it bulges towards the eye: its rays go apart, and none meets the surface twice.
bool seesConvexSide(const Shape& shape, const Point& eye);

/// What is wrong with the shape itself (a quad that is not planar, a radius that is not > 0), in a sentence;
/// nothing when it is sound.
std::optional<std::string> findShapeProblem(const Shape& shape);

/// Why no anamorphosis can be made of a sound shape from this eye, in a sentence a student understands and
/// with what to do about it; nothing when it can.
std::optional<std::string> findEyeProblem(const Shape& shape, const Point& eye);

/// An eye near this one from which it can, on the side away from the original's middle.
Point eyeOutside(const Shape& shape, const Point& eye, const Point& original);

/// About how much memory it takes with what is made of it once; without its cut surface, and without its file's mesh.
std::size_t bytesOf(const Shape& shape);

/// The mesh file that its surface is; null: it is made of none.
const SurfaceFile* surfaceFileOf(const Shape& shape);

/// The same without the surface that is kept of a cut one: for shapes that may never be shown again.
Shape withoutCutSurface(const Shape& shape);

/// What the shape is called in files and messages: "plane", "cylinder", ...
const char* shapeName(const Shape& shape);

/// Of the finite surface: exact for quadrics, of a cut one as exact as its triangles are.
Box boxOf(const Shape& shape);

/// What it turns about and is put in place by.
Point middleOf(const Shape& shape);

/// Along which it is scaled; the scene's for one that stands upright. Not unit for a shape with a problem.
Axes axesOf(const Shape& shape);

/// Whether it looks the same however it is turned: a sphere.
bool isRound(const Shape& shape);

/// Whether it has one size only, whatever is cut off.
bool hasOneSize(const Shape& shape);

/// Sound for every shape.
ShapeExtent extentOf(const Shape& shape);

/// The radius about its middle when it is a full circle seen from above; nothing when it is not.
std::optional<double> circleFromAbove(const Shape& shape);

/// From a point of the surface to its border as a fraction of its size; 1 when it has no border.
double borderDistance(const Shape& shape, const Point& point);

/// A point of the surface for parameters 0..1.
Point pointAt(const Shape& shape, double u, double v);

/// The surface as triangles, for drawing, cut off as it is; vertices lie on the surface, but for cuts on their straight
/// edges. Curved shapes get `segments` around. Hits are always computed on the exact surface instead. Normals are there
/// when the shape's shader is tessellatedShader.
SmoothMesh tessellate(const Shape& shape, int segments = 96);

/// The name of its file in shaders/shapes.
const char* shaderOf(const Shape& shape);

/// Hands all fields to `fields`, which may change them.
void visitFields(Shape& shape, ShapeFields& fields);

/// Moved, turned or scaled.
Shape mapShape(const Shape& shape, const ShapeMap& map);

/// What of the shape can be dragged point by point: the control points of its splines; empty: nothing.
std::vector<ControlPoint> controlPointsOf(const Shape& shape);

/// With one of them moved along the axes that it is free along.
Shape withControlPointMoved(const Shape& shape, std::size_t number, const Vector& motion);

/// Grown a little beyond its outline and far beyond its ends.
Shape continued(const Shape& shape);

template <ConcreteShape S>
Shape::Shape(S&& shape)
    : any_(std::make_shared<const ShapeOf<std::remove_cvref_t<S>>>(std::forward<S>(shape))) {}

template <typename S>
const S* Shape::as() const {
  const auto* same = dynamic_cast<const ShapeOf<S>*>(any_.get());
  return same ? &same->shape() : nullptr;
}

}  // namespace anamorph
