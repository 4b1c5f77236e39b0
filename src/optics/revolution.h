// The mirror of a turned profile, such as a vase: the radius at every height is a uniform cubic B-spline; open at both
// ends.
//
//      .-top-.         rho^2 = r(h)^2: along a ray, which is cut at the spline's knots, both sides are polynomials of
//       )   (          degree 2 and 6 (math/bernstein.h)
//      '-bottom-'
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "math/uniform_spline.h"
#include "optics/spline_ray.h"

namespace anamorph {

struct RevolutionMirror {
  static constexpr const char *name = "revolution", *label = "Turned profile";
  static constexpr int since = 2;

  Point bottom{0, 0, 0};
  Point top{0, 0, 8};
  std::vector<double> radii{2.2, 2.6, 3,   3.1, 2.8,
                            2.2, 1.8, 1.7, 1.9};  ///< control values, from the bottom up
  bool operator==(const RevolutionMirror&) const = default;

  void visitFields(ShapeFields& fields) {
    fields.point({"bottom", "Bottom", "The lower end of the axis."}, bottom);
    fields.point({"top", "Top", "The upper end of the axis."}, top);
    fields.radii({"radii", "Radius", "What the profile is drawn towards, from the bottom up."}, radii);
    fields.distance({"", "Height", "The bottom stays where it is."}, bottom, top);
  }

  double height() const { return glm::length(top - bottom); }
  Direction axis() const { return glm::normalize(top - bottom); }
  double widest() const { return rangeOf(splineSpans(radii)).second; }

  // ---- Rays

  struct Span {
    Cubic radius;
    double least, greatest;  // exact
  };
  struct Prepared {
    Axes axes;
    double height, widest;
    std::vector<Span> spans;

    double spanHeight() const { return height / static_cast<double>(spans.size()); }
    /// At a height; its slope a unit of height.
    ValueAndSlope radiusAt(double h) const;
  };
  Prepared prepare() const;
  std::optional<SurfaceHit> intersect(const Prepared& prepared, const Ray& ray, double tMin) const {
    return firstHit(prepared, ray, tMin, {});
  }
  bool meetsBetween(const Prepared& prepared, const Ray& ray, double tMin, double tMax) const {
    return firstHit(prepared, ray, tMin, {tMin, tMax}).has_value();
  }

  std::size_t bytes() const { return radii.size() * (sizeof(double) + sizeof(Span)); }

  // ---- What can be wrong

  std::optional<std::string> findProblem() const;
  std::optional<std::string> findEyeProblem(const Prepared& prepared, const Point& eye) const;
  Point eyeOutside(const Point& eye, const Point& original) const;

  // ---- Its place

  Box box() const;
  Point middle() const { return 0.5 * (bottom + top); }
  Axes axes() const { return axesAlong(axis()); }
  ShapeExtent extent() const { return {middle(), axis(), 2 * widest(), height()}; }
  static RevolutionMirror filling(const ShapeExtent& room, const Point& eye);
  std::vector<ControlPoint> controlPoints() const;
  void moveControlPoint(std::size_t number, const Vector& motion);
  void map(const ShapeMap& map);
  /// As wide as its ends, as far again as it is high.
  void carryOn();

  // ---- How it is drawn and described

  Point pointAt(double u, double v) const;
  Direction normalAt(double u, double v) const;
  std::array<int, 2> gridFor(int segments) const;
  SurfaceLines lines() const;
  std::optional<double> circleFromAbove() const {
    return isUpright(top - bottom) ? std::optional(widest()) : std::nullopt;
  }
  double borderDistance(const Point& p) const;
  ShapeWords words(LengthText text) const;

 private:
  /// The first crossing at t > tMin of a stretch of the ray.
  std::optional<SurfaceHit> firstHit(const Prepared& prepared, const Ray& ray, double tMin,
                                     const Stretch& within) const;
  int spanCount() const;
};

}  // namespace anamorph
