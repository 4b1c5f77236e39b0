// The mirror of a curve that is drawn along an axis, such as a wavy wall or a pillar of any outline: a uniform cubic
// B-spline in the plane of X and Y, from there to a height along Z. Both ends are open.
//
//        Y   __          Z = unit(axis), X = unit(across), made perpendicular to it, Y = Z x X.
//        |  /  '-._      Along Z the ray is one line in the plane of the curve: a cubic in u for every span.
//        '-------------X
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "math/plane_curve.h"
#include "optics/shape_helpers.h"

namespace anamorph {

struct ExtrusionMirror {
  static constexpr const char *name = "extrusion", *label = "Curved wall";
  static constexpr int since = 2;

  Point origin{0, 0, 0};
  Vector axis{0, 0, 1};    ///< of any length > 0
  Vector across{1, 0, 0};  ///< not along the axis
  double height = 6;
  std::vector<CurvePoint> points{{-9, 0},   {-7, 0.15}, {-5, -0.15}, {-3, 0.15}, {-1, -0.15},
                                 {1, 0.15}, {3, -0.15}, {5, 0.15},   {7, -0.15}, {9, 0}};  ///< control points
  bool closed = false;
  bool operator==(const ExtrusionMirror&) const = default;

  void visitFields(ShapeFields& fields) {
    fields.point({"origin", "Origin", "Where the curve's plane has its 0, 0."}, origin);
    fields.direction({"axis", "Axis", "Along which the curve is drawn into a wall."}, axis);
    fields.direction({"across", "Across", "The curve's x axis."}, across);
    fields.length({"height", "Height", "Along the axis."}, height);
    fields.curve({.key = "points",
                  .label = "Point",
                  .help = "What the curve is drawn towards.",
                  .fewest = closed ? fewestClosedControls : fewestOpenControls},
                 points);
    fields.flag({"closed", "Closed", "Whether the curve's end runs into its beginning.", false, true},
                closed);
  }

  // ---- Rays

  struct Prepared {
    Axes axes;
    Point base;         ///< of the curve's middle, in space
    CurvePoint centre;  ///< the same in the curve's plane
    double size;        ///< of the curve
    PlaneCurve curve;   ///< as seen from there
    struct Fault {
      CurvePoint at;  ///< in the curve's own plane
      bool isSharp;   ///< there; else it meets itself
    };
    std::optional<Fault> fault;  ///< of the curve itself
  };
  Prepared prepare() const;
  std::optional<SurfaceHit> intersect(const Prepared& prepared, const Ray& ray, double tMin) const;

  std::size_t bytes() const { return points.size() * (sizeof(CurvePoint) + sizeof(PlaneCubic)); }

  // ---- What can be wrong

  std::optional<std::string> findProblem(const Prepared& prepared) const;
  std::optional<std::string> findEyeProblem(const Prepared& prepared, const Point& eye) const;
  Point eyeOutside(const Prepared& prepared, const Point& eye, const Point& original) const;

  // ---- Its place

  Box box() const;
  Point middle(const Prepared& prepared) const;
  Axes axes() const;
  ShapeExtent extent(const Prepared& prepared) const;
  /// A gentle wave, towards the eye.
  static ExtrusionMirror filling(const ShapeExtent& room, const Point& eye);
  std::vector<ControlPoint> controlPoints() const;
  void moveControlPoint(std::size_t number, const Vector& motion);
  void map(const ShapeMap& map);
  /// Straight on, as far again as it is wide; far beyond its ends.
  void carryOn();

  // ---- How it is drawn and described

  Point pointAt(double u, double v) const;
  Direction normalAt(double u, double v) const;
  std::array<int, 2> gridFor(int segments) const;
  SurfaceLines lines() const;
  double borderDistance(const Prepared& prepared, const Point& p) const;
  ShapeWords words(LengthText text) const;

  struct Place {
    CurvePoint point, slope;
  };

 private:
  int spanCount() const;
  Place placeAt(double u) const;  ///< 0..1 along the curve
};

}  // namespace anamorph
