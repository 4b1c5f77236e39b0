// The arithmetic of one ray and a cylinder or sphere, shared by the single ray (mirror_shapes.h) and by many
// rays (exit_points.h), so that both give the same bits. Both are the same quadratic |w + t u|^2 = r^2, where
// w and u are the eye and the ray seen from the centre; for a cylinder their part along the axis is removed
// first.
//
//        E *---- u ---->          t = (-b -+ sqrt(b^2 - a c)) / a,   a = u.u,  b = u.w,  c = w.w - r^2
//           \         _____
//          w \       /     \      (the smaller root as c / q with q = -b + sqrt(...): no cancellation)
//             \_____|   C   |
#pragma once

#include "optics/mirror_shapes.h"

namespace anamorph {

/// The first root when the eye is outside and the ray comes nearer; `valid` is false otherwise.
struct NearRoot {
  double t;
  bool valid;
};

inline NearRoot nearRoot(const Vector& w, const Vector& u, double c) {
  const double a = glm::dot(u, u), b = glm::dot(u, w);
  const double discriminant = b * b - a * c;
  const bool valid = (discriminant >= 0) & (b < 0) & (c > 0);
  return {c / (std::sqrt(std::abs(discriminant)) - b), valid};  // abs: no branch, so that loops vectorise
}

struct SphereForm {
  SphereForm(const SphereMirror& sphere, const Point& eye)
      : w(eye - sphere.centre),
        c(glm::dot(w, w) - sphere.radius * sphere.radius),
        inverseRadius(1 / sphere.radius) {}

  Vector across(const Vector& v) const { return v; }
  bool contains(double, const Vector&) const { return true; }

  Vector w;
  double c;
  double inverseRadius;
};

struct CylinderForm {
  CylinderForm(const CylinderMirror& cylinder, const Point& eye)
      : height(glm::length(cylinder.top - cylinder.bottom)),
        axis((cylinder.top - cylinder.bottom) / height),
        along(glm::dot(eye - cylinder.bottom, axis)),
        w(across(eye - cylinder.bottom)),
        c(glm::dot(w, w) - cylinder.radius * cylinder.radius),
        inverseRadius(1 / cylinder.radius) {}

  /// The part of a vector perpendicular to the axis.
  Vector across(const Vector& v) const { return v - glm::dot(v, axis) * axis; }
  /// Whether E + t V is between the two ends.
  bool contains(double t, const Vector& v) const {
    const double position = along + t * glm::dot(v, axis);
    return (position >= 0) & (position <= height);
  }

  double height;
  Direction axis;
  double along;  // of the eye, from the bottom
  Vector w;
  double c;
  double inverseRadius;
};

}  // namespace anamorph
