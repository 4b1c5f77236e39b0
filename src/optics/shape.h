// A surface that light meets: all that the rest of the program may ask of one. Every shape is a struct in a file
// of its own (plane.h, cylinder.h, ...) that answers these questions; Shape is a value that holds any of them.
// Nothing outside of this room names a concrete shape, and no other code switches over shapes.
//
//     plane.h  cylinder.h  cone.h  sphere.h  ...     one file a shape: fields, hit, normal, box, axes, words
//          \       \        /       /
//           shape_table.cpp                           their names: files, panels and lessons ask this table
//                  |
//                Shape                                level, map, tracer, edits, sheet, 3D view
//
// To add a shape: one file like cone.h, its line in shape_table.cpp, its shaders/shapes/<name>.glsl, its words in
// assets/languages, its tests. What a shape need not have (a batch form of its map, for example) is told by its
// absence: see ShapeOf below.
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

#include "geometry/mesh.h"
#include "math/box.h"
#include "math/frame.h"
#include "math/ray.h"
#include "optics/exit_kernel.h"

namespace anamorph {

struct SurfaceHit {
  double t = 0;         ///< along the ray, in lengths of its direction
  Point point{0};       ///< on the surface
  Direction normal{0};  ///< unit, towards the ray's origin: dot(normal, direction) <= 0
};

/// Perpendicular, right-handed.
using Axes = std::array<Direction, 3>;
inline const Axes sceneAxes{Direction(1, 0, 0), Direction(0, 1, 0), Direction(0, 0, 1)};

/// How a shape is moved, turned or scaled: where its points go, and by which factors its sizes along its own axes
/// change.
struct ShapeMap {
  std::function<Point(const Point&)> point;
  Vector factors{1};
  double minSize = 0, maxSize = std::numeric_limits<double>::infinity();  ///< what a size is kept within

  double size(double length, double factor) const;
  /// Of a size that several axes share.
  double size(double length, std::initializer_list<double> candidates) const;
  /// Of factors for one size, the one that is meant: that differs most from 1.
  static double strongest(std::initializer_list<double> factors);
};

/// What all shapes have in common, to put one in another's place: a middle, a way up, a width and a height.
struct ShapeExtent {
  Point middle{0};
  Direction up{0, 0, 1};
  double width = 6, height = 6;
};

/// The lines by which a surface is drawn that light passes through: at even steps of its parameters u and v.
struct SurfaceLines {
  int stepsU = 8, stepsV = 8;            ///< intervals between lines of constant u, of constant v
  bool closedU = false;                  ///< u = 1 is u = 0 again
  int chordsU = 1, chordsV = 1;          ///< straight pieces of a line along u, along v
  std::vector<double> strongU, strongV;  ///< lines that are drawn strongly: borders
};

/// A shape's numbers for its shader, shaders/shapes/<name>.glsl; places relative to an origin.
constexpr std::size_t shapeVectors = 8;
using PackedShape = std::array<glm::dvec4, shapeVectors>;

/// A shape in words, for the sheet that a maker sets it up by, in the chosen language.
struct ShapeWords {
  std::string size;    ///< sentences about the thing itself: "A ball of 80.0 mm diameter. "
  std::string stance;  ///< how it stands on its drawn outline, without the full stop
};
/// Millimetres as the sheet writes them.
using LengthText = std::string (*)(double);

/// A field of a shape as files and panels know it.
struct FieldName {
  const char* key;    ///< in files
  const char* label;  ///< in panels, English
  const char* help = "";
  bool mayBeZero = false;  ///< of a length: else it is > 0
};

/// Walks over the fields of a shape, which call it in the order of the file.
class ShapeFields {
 public:
  virtual ~ShapeFields() = default;
  virtual void point(const FieldName& name, Point& value) = 0;
  virtual void length(const FieldName& name, double& value) = 0;
  /// Several points under one key; in panels each has the label and its number.
  virtual void points(const FieldName& name, std::span<Point> values) = 0;
  /// A length that is no field, because it follows from two points; only panels show it.
  virtual void distance(const FieldName& /*name*/, const Point& /*from*/, Point& /*to*/) {}
};

class AnyShape;

template <typename S>
concept ConcreteShape = requires {
  std::remove_cvref_t<S>::name;
  std::remove_cvref_t<S>::label;
};

/// A shape by value. Copies share what never changes, so they are cheap; equal fields are equal shapes.
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

  /// The concrete shape when it is an S, else null: for files that name one, and for tests.
  template <typename S>
  const S* as() const;

 private:
  friend void visitFields(Shape& shape, ShapeFields& fields);
  friend Shape mapShape(const Shape& shape, const ShapeMap& map);
  friend Shape continued(const Shape& shape);
  explicit Shape(std::shared_ptr<const AnyShape> any) : any_(std::move(any)) {}

  std::shared_ptr<const AnyShape> any_;
};

/// What a shape answers; the sentences are at the functions below.
class AnyShape {
 public:
  virtual ~AnyShape() = default;
  virtual bool equals(const AnyShape& other) const = 0;
  virtual std::shared_ptr<AnyShape> copy() const = 0;

  virtual const char* name() const = 0;
  virtual std::optional<SurfaceHit> intersect(const Ray& ray, double tMin) const = 0;
  virtual std::size_t exitPoints(const ExitBlock& block) const = 0;
  virtual std::optional<Direction> publishedNormal(const Point& point) const = 0;

  virtual std::optional<std::string> findProblem() const = 0;
  virtual std::optional<std::string> findEyeProblem(const Point& eye) const = 0;
  virtual Point eyeOutside(const Point& eye, const Point& original) const = 0;

  virtual Box box() const = 0;
  virtual Point middle() const = 0;
  virtual Axes axes() const = 0;
  virtual bool isRound() const = 0;
  virtual ShapeExtent extent() const = 0;
  virtual std::optional<double> circleFromAbove() const = 0;
  virtual double borderDistance(const Point& point) const = 0;

  virtual Point pointAt(double u, double v) const = 0;
  virtual std::array<int, 2> gridFor(int segments) const = 0;
  virtual SurfaceLines lines() const = 0;
  virtual PackedShape packed(const Point& origin) const = 0;
  virtual ShapeWords words(LengthText text) const = 0;

  virtual void visitFields(ShapeFields& fields) = 0;
  virtual void map(const ShapeMap& map) = 0;
  virtual void carryOn() = 0;
};

/// The first hit at t > tMin; nothing when the ray misses. Both sides of a surface reflect.
std::optional<SurfaceHit> intersect(const Shape& shape, const Ray& ray, double tMin = 0);

/// What is wrong with the shape itself (a quad that is not planar, a radius that is not > 0), in a sentence;
/// nothing when it is sound.
std::optional<std::string> findShapeProblem(const Shape& shape);

/// Why no anamorphosis can be made of a sound shape from this eye, in a sentence a student understands and
/// with what to do about it; nothing when it can.
std::optional<std::string> findEyeProblem(const Shape& shape, const Point& eye);

/// An eye near this one from which it can, on the side away from the original's middle.
Point eyeOutside(const Shape& shape, const Point& eye, const Point& original);

/// What the shape is called in files and messages: "plane", "cylinder", ...
const char* shapeName(const Shape& shape);

/// Exact, of the finite surface.
Box boxOf(const Shape& shape);

/// What it turns about and is put in place by.
Point middleOf(const Shape& shape);

/// Along which it is scaled; the scene's for one that stands upright. Not unit for a shape with a problem.
Axes axesOf(const Shape& shape);

/// Whether it looks the same however it is turned, and has one size only: a sphere.
bool isRound(const Shape& shape);

/// Sound for every shape.
ShapeExtent extentOf(const Shape& shape);

/// The radius about its middle when it is a full circle seen from above; nothing when it is not.
std::optional<double> circleFromAbove(const Shape& shape);

/// From a point of the surface to its border as a fraction of its size; 1 when it has no border.
double borderDistance(const Shape& shape, const Point& point);

/// A point of the surface for parameters 0..1.
Point pointAt(const Shape& shape, double u, double v);

/// The surface as triangles, for drawing; vertices lie on the surface. Curved shapes get `segments` around. Hits
/// are always computed on the exact surface instead.
Mesh tessellate(const Shape& shape, int segments = 96);

/// Hands all fields to `fields`, which may change them.
void visitFields(Shape& shape, ShapeFields& fields);

/// Moved, turned or scaled.
Shape mapShape(const Shape& shape, const ShapeMap& map);

/// Grown a little beyond its outline and far beyond its ends.
Shape continued(const Shape& shape);

// ---- From a concrete shape to a Shape. The compiler asks for what is missing; `requires` tells what need not be.

template <typename S>
class ShapeOf final : public AnyShape {
 public:
  explicit ShapeOf(S shape) : shape_(std::move(shape)) {}
  const S& shape() const { return shape_; }

  bool equals(const AnyShape& other) const override {
    const auto* same = dynamic_cast<const ShapeOf*>(&other);
    return same && same->shape_ == shape_;
  }
  std::shared_ptr<AnyShape> copy() const override { return std::make_shared<ShapeOf>(shape_); }

  const char* name() const override { return S::name; }
  std::optional<SurfaceHit> intersect(const Ray& ray, double tMin) const override {
    return shape_.intersect(ray, tMin);
  }
  std::size_t exitPoints(const ExitBlock& block) const override {
    if constexpr (requires { shape_.bounceFrom(block.eye); }) {
      return followBlock(shape_.bounceFrom(block.eye), block);
    } else {  // without a batch form every ray is followed by itself
      return followNone(block);
    }
  }
  std::optional<Direction> publishedNormal(const Point& point) const override {
    if constexpr (requires { shape_.publishedNormal(point); }) {
      return shape_.publishedNormal(point);
    } else {
      return std::nullopt;
    }
  }

  std::optional<std::string> findProblem() const override { return shape_.findProblem(); }
  std::optional<std::string> findEyeProblem(const Point& eye) const override {
    return shape_.findEyeProblem(eye);
  }
  Point eyeOutside(const Point& eye, const Point& original) const override {
    return shape_.eyeOutside(eye, original);
  }

  Box box() const override { return shape_.box(); }
  Point middle() const override { return shape_.middle(); }
  Axes axes() const override { return shape_.axes(); }
  bool isRound() const override {
    if constexpr (requires { S::isRound; }) {
      return S::isRound;
    } else {
      return false;
    }
  }
  ShapeExtent extent() const override { return shape_.extent(); }
  std::optional<double> circleFromAbove() const override {
    if constexpr (requires { shape_.circleFromAbove(); }) {
      return shape_.circleFromAbove();
    } else {
      return std::nullopt;
    }
  }
  double borderDistance(const Point& point) const override { return shape_.borderDistance(point); }

  Point pointAt(double u, double v) const override { return shape_.pointAt(u, v); }
  std::array<int, 2> gridFor(int segments) const override { return shape_.gridFor(segments); }
  SurfaceLines lines() const override { return shape_.lines(); }
  PackedShape packed(const Point& origin) const override { return shape_.packed(origin); }
  ShapeWords words(LengthText text) const override { return shape_.words(text); }

  void visitFields(ShapeFields& fields) override { shape_.visitFields(fields); }
  void map(const ShapeMap& map) override { shape_.map(map); }
  void carryOn() override { shape_.carryOn(); }

 private:
  S shape_;
};

template <ConcreteShape S>
Shape::Shape(S&& shape)
    : any_(std::make_shared<const ShapeOf<std::remove_cvref_t<S>>>(std::forward<S>(shape))) {}

template <typename S>
const S* Shape::as() const {
  const auto* same = dynamic_cast<const ShapeOf<S>*>(any_.get());
  return same ? &same->shape() : nullptr;
}

}  // namespace anamorph
