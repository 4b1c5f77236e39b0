// Smooth curves in a plane, made of cubics that follow each other: whether such a curve has sharp points, comes near a
// point, or meets itself. Pieces that turn little are compared by the strips that they lie in, and split where those
// overlap.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "math/bernstein.h"

namespace anamorph {

struct PlaneCubic {
  Cubic x, y;

  glm::dvec2 control(std::size_t i) const { return {x.c[i], y.c[i]}; }
};
using PlaneCurve = std::vector<PlaneCubic>;

/// The spline of these control points (uniform_spline.h).
PlaneCurve splineCurve(std::span<const glm::dvec2> controls, bool closed);

/// Where it has no direction; `size` is about how large the curve is. Nothing when it has one everywhere.
std::optional<glm::dvec2> findSharpPoint(const PlaneCurve& curve, double size);

/// Where two places of a curve without sharp points that do not follow each other are no farther apart than `gap`.
std::optional<glm::dvec2> findSelfContact(const PlaneCurve& curve, bool closed, double gap);

/// Whether it comes as near to a point as `gap`.
bool comesNear(const PlaneCurve& curve, const glm::dvec2& point, double gap);

}  // namespace anamorph
