// What every shape answers, and how a struct of a file of its own comes to answer it. Only shape.h includes this.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec4.hpp>

#include "base/lazy.h"
#include "geometry/smooth_mesh.h"
#include "math/box.h"
#include "math/ray.h"
#include "optics/exit_kernel.h"
#include "optics/shape_fields.h"

namespace anamorph {

struct SurfaceHit {
  double t = 0;         ///< along the ray, in lengths of its direction
  Point point{0};       ///< on the surface
  Direction normal{0};  ///< unit, towards the ray's origin: dot(normal, direction) <= 0
  /// Where the normal is a mean of its neighbours' (meshes): unit, of the flat piece itself. A ray that would leave into
  /// its own piece grazes. 0: the surface is what its normals say.
  Direction facet{0};
};

/// Perpendicular, right-handed.
using Axes = std::array<Direction, 3>;
inline const Axes sceneAxes{Direction(1, 0, 0), Direction(0, 1, 0), Direction(0, 0, 1)};

/// How a shape is moved, turned or scaled: where its points go, and by which factors its sizes along its own axes
/// change.
struct ShapeMap {
  std::function<Point(const Point&)> point;
  Vector factors{1};
  /// Radians below which a direction is not turned: more than what places far from the origin lose by rounding.
  static constexpr double notTurned = 1e-9;
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

/// The lines by which a surface is drawn that light passes through: at even steps of its parameters u and v. Without
/// steps some of its triangles are.
struct SurfaceLines {
  int stepsU = 8, stepsV = 8;            ///< intervals between lines of constant u, of constant v
  bool closedU = false;                  ///< u = 1 is u = 0 again
  int chordsU = 1, chordsV = 1;          ///< straight pieces of a line along u, along v
  std::vector<double> strongU, strongV;  ///< lines that are drawn strongly: borders
};

/// A shape's numbers for its shader, shaders/shapes/<name>.glsl; places relative to an origin.
constexpr std::size_t shapeVectors = 8;
using PackedShape = std::array<glm::dvec4, shapeVectors>;

/// A field of a shape as a place in the scene: it moves along the first `freedom` of its axes.
struct ControlPoint {
  Point at{0};
  Axes axes = sceneAxes;
  int freedom = 1;
};

/// A shape in words, for the sheet that a maker sets it up by, in the chosen language.
struct ShapeWords {
  std::string size;    ///< sentences about the thing itself: "A ball of 80.0 mm diameter. "
  std::string stance;  ///< how it stands on its drawn outline, without the full stop
};
/// Millimetres as the sheet writes them.
using LengthText = std::string (*)(double);

template <typename S>
concept ConcreteShape = requires {
  std::remove_cvref_t<S>::name;
  std::remove_cvref_t<S>::label;
};

/// What is made once of a shape, and asked by every ray: pieces of a spline, a tree of triangles. A shape that has such a
/// thing has prepare(), which answers whatever the fields are, and its intersect() takes it first; other questions may.
template <typename S>
concept PreparedShape = requires(const S& shape) {
  shape.prepare();
};

/// What a shape answers; the sentences are at the functions of shape.h.
class AnyShape {
 public:
  virtual ~AnyShape() = default;
  virtual bool equals(const AnyShape& other) const = 0;
  virtual std::shared_ptr<AnyShape> copy() const = 0;

  virtual const char* name() const = 0;
  virtual std::size_t bytes() const = 0;
  virtual const SurfaceFile* file() const = 0;
  virtual std::optional<SurfaceHit> intersect(const Ray& ray, double tMin) const = 0;
  virtual bool meetsBetween(const Ray& ray, double tMin, double tMax) const = 0;
  virtual std::size_t exitPoints(const ExitBlock& block) const = 0;
  virtual bool hasBatch() const = 0;
  virtual bool seesConvexSide(const Point& eye) const = 0;
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
  virtual SmoothMesh tessellate(int segments) const = 0;
  virtual SurfaceLines lines() const = 0;
  virtual const char* shader() const = 0;
  virtual PackedShape packed(const Point& origin) const = 0;
  virtual ShapeWords words(LengthText text) const = 0;

  virtual void visitFields(ShapeFields& fields) = 0;
  virtual std::vector<ControlPoint> controlPoints() const = 0;
  virtual void moveControlPoint(std::size_t number, const Vector& motion) = 0;
  virtual void map(const ShapeMap& map) = 0;
  virtual void carryOn() = 0;
};

/// The shader of shapes that have no numbers of their own for one: their triangles are traced.
inline constexpr const char* tessellatedShader = "tessellated";

/// A grid of (columns + 1) x (rows + 1) points with u and v in 0..1; without `normalAt` it has no normals.
SmoothMesh tessellateGrid(int columns, int rows, const std::function<Point(double u, double v)>& pointAt,
                          const std::function<Direction(double u, double v)>& normalAt);

// From a concrete shape to a Shape. The compiler asks for what is missing; `requires` tells what need not be.

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
  std::size_t bytes() const override {
    if constexpr (requires { shape_.bytes(); }) {
      return sizeof *this + shape_.bytes();
    } else {
      return sizeof *this;
    }
  }
  const SurfaceFile* file() const override {
    if constexpr (requires { shape_.file; }) {
      return &shape_.file;
    } else {
      return nullptr;
    }
  }
  std::optional<SurfaceHit> intersect(const Ray& ray, double tMin) const override {
    if constexpr (PreparedShape<S>) {
      return shape_.intersect(prepared(), ray, tMin);
    } else {
      return shape_.intersect(ray, tMin);
    }
  }
  bool meetsBetween(const Ray& ray, double tMin, double tMax) const override {
    if constexpr (requires(const S& s, const Prepared& p) { s.meetsBetween(p, ray, tMin, tMax); }) {
      return shape_.meetsBetween(prepared(), ray, tMin, tMax);
    } else {
      const auto hit = intersect(ray, tMin);
      return hit && hit->t < tMax;
    }
  }
  std::size_t exitPoints(const ExitBlock& block) const override {
    if constexpr (requires { shape_.hollowBounceFrom(block.eye); }) {
      if (!shape_.seesConvexSide(block.eye)) return followBlock(shape_.hollowBounceFrom(block.eye), block);
    }
    if constexpr (requires { shape_.bounceFrom(block.eye); }) {
      return followBlock(shape_.bounceFrom(block.eye), block);
    } else {
      return followNone(block);
    }
  }
  bool hasBatch() const override {
    return requires(const S& s, const Point& eye) {
      s.bounceFrom(eye);
    };
  }
  bool seesConvexSide(const Point& eye) const override {
    if constexpr (requires { shape_.seesConvexSide(eye); }) {
      return shape_.seesConvexSide(eye);
    } else {
      return false;
    }
  }
  std::optional<Direction> publishedNormal(const Point& point) const override {
    if constexpr (requires { shape_.publishedNormal(point); }) {
      return shape_.publishedNormal(point);
    } else {
      return std::nullopt;
    }
  }

  std::optional<std::string> findProblem() const override {
    if constexpr (requires(const S& s, const Prepared& p) { s.findProblem(p); }) {
      return shape_.findProblem(prepared());
    } else {
      return shape_.findProblem();
    }
  }
  std::optional<std::string> findEyeProblem(const Point& eye) const override {
    if constexpr (PreparedShape<S>) {
      return shape_.findEyeProblem(prepared(), eye);
    } else {
      return shape_.findEyeProblem(eye);
    }
  }
  Point eyeOutside(const Point& eye, const Point& original) const override {
    if constexpr (requires(const S& s, const Prepared& p) { s.eyeOutside(p, eye, original); }) {
      return shape_.eyeOutside(prepared(), eye, original);
    } else {
      return shape_.eyeOutside(eye, original);
    }
  }

  Box box() const override {
    if constexpr (requires(const S& s, const Prepared& p) { s.box(p); }) {
      return shape_.box(prepared());
    } else if constexpr (PreparedShape<S>) {  // of a spline it is a search
      return box_.get([this] { return shape_.box(); });
    } else {
      return shape_.box();
    }
  }
  Point middle() const override {
    if constexpr (requires(const S& s, const Prepared& p) { s.middle(p); }) {
      return shape_.middle(prepared());
    } else {
      return shape_.middle();
    }
  }
  Axes axes() const override { return shape_.axes(); }
  bool isRound() const override {
    if constexpr (requires { S::isRound; }) {
      return S::isRound;
    } else {
      return false;
    }
  }
  ShapeExtent extent() const override {
    if constexpr (requires(const S& s, const Prepared& p) { s.extent(p); }) {
      return shape_.extent(prepared());
    } else {
      return shape_.extent();
    }
  }
  std::optional<double> circleFromAbove() const override {
    if constexpr (requires { shape_.circleFromAbove(); }) {
      return shape_.circleFromAbove();
    } else {
      return std::nullopt;
    }
  }
  double borderDistance(const Point& point) const override {
    if constexpr (requires(const S& s, const Prepared& p) { s.borderDistance(p, point); }) {
      return shape_.borderDistance(prepared(), point);
    } else {
      return shape_.borderDistance(point);
    }
  }

  Point pointAt(double u, double v) const override { return shape_.pointAt(u, v); }
  SmoothMesh tessellate(int segments) const override {
    if constexpr (requires { shape_.tessellate(segments); }) {
      return shape_.tessellate(segments);
    } else {
      const auto [columns, rows] = shape_.gridFor(segments);
      if constexpr (requires { shape_.normalAt(0.0, 0.0); }) {
        return tessellateGrid(
            columns, rows, [&](double u, double v) { return shape_.pointAt(u, v); },
            [&](double u, double v) { return shape_.normalAt(u, v); });
      } else {
        return tessellateGrid(columns, rows, [&](double u, double v) { return shape_.pointAt(u, v); }, {});
      }
    }
  }
  SurfaceLines lines() const override { return shape_.lines(); }
  const char* shader() const override {
    if constexpr (requires { shape_.packed(Point{}); }) {
      return S::name;
    } else {
      return tessellatedShader;
    }
  }
  PackedShape packed(const Point& origin) const override {
    if constexpr (requires { shape_.packed(origin); }) {
      return shape_.packed(origin);
    } else {
      return {};
    }
  }
  ShapeWords words(LengthText text) const override {
    if constexpr (requires(const S& s, const Prepared& p) { s.words(p, text); }) {
      return shape_.words(prepared(), text);
    } else {
      return shape_.words(text);
    }
  }

  void visitFields(ShapeFields& fields) override { shape_.visitFields(fields); }
  std::vector<ControlPoint> controlPoints() const override {
    if constexpr (requires { shape_.controlPoints(); }) {
      return shape_.controlPoints();
    } else {
      return {};
    }
  }
  void moveControlPoint(std::size_t number, const Vector& motion) override {
    if constexpr (requires { shape_.moveControlPoint(number, motion); }) {
      shape_.moveControlPoint(number, motion);
    }
  }
  void map(const ShapeMap& map) override { shape_.map(map); }
  void carryOn() override { shape_.carryOn(); }

 private:
  struct Nothing {
    bool operator==(const Nothing&) const = default;
  };
  template <typename T>
  struct PreparedOf {
    using Type = Nothing;
  };
  template <PreparedShape T>
  struct PreparedOf<T> {
    using Type = decltype(std::declval<const T&>().prepare());
  };
  using Prepared = typename PreparedOf<S>::Type;
  const Prepared& prepared() const {
    return prepared_.get([this] { return shape_.prepare(); });
  }

  S shape_;  // never changes once something has been prepared of it: a Shape changes copies only
  Lazy<Prepared> prepared_;
  Lazy<Box> box_;
};

}  // namespace anamorph
