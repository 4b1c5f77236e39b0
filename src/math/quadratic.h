// Real roots of a t^2 + 2 b t + c = 0 without cancellation (the half-b form of ray and quadric).
#pragma once

#include <cmath>
#include <optional>
#include <utility>

namespace anamorph {

/// The two roots in ascending order, for a > 0; nothing when they are complex or a is not > 0.
/// The far-from-zero root is taken first and the other one from their product c / a, so neither loses digits.
inline std::optional<std::pair<double, double>> solveQuadratic(double a, double halfB, double c) {
  const double discriminant = halfB * halfB - a * c;
  if (!(a > 0) || !(discriminant >= 0)) return std::nullopt;
  const double q = -(halfB + std::copysign(std::sqrt(discriminant), halfB));
  const double first = q / a;
  const double second = q != 0 ? c / q : 0;
  return first < second ? std::pair{first, second} : std::pair{second, first};
}

/// The same for any a: a root that there is not (a = 0) is infinite. Nothing when they are complex, or when all
/// t or none will do.
inline std::optional<std::pair<double, double>> solveAnyQuadratic(double a, double halfB, double c) {
  const double discriminant = halfB * halfB - a * c;
  if (!(discriminant >= 0)) return std::nullopt;
  const double q = -(halfB + std::copysign(std::sqrt(discriminant), halfB));
  if (a == 0 && q == 0) return std::nullopt;
  const double first = q / a;
  const double second = q != 0 ? c / q : 0;
  return first < second ? std::pair{first, second} : std::pair{second, first};
}

}  // namespace anamorph
