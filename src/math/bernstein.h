// Polynomials in Bernstein form over 0..1, up to degree 6, and where they cross 0. What a ray meets on a spline are such
// crossings: along the ray a spline is piecewise polynomial.
//
// The polynomial lies within its coefficients: no change of sign among them is no crossing, one is exactly one, and
// more are split. Only then Newton's method is asked, and it never leaves the bracket: so the first crossing is found
// and not just any.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace anamorph {

/// Sum of c[i] binomial(degree, i) s^i (1 - s)^(degree - i).
template <int degree>
struct Bernstein {
  std::array<double, degree + 1> c{};

  bool operator==(const Bernstein&) const = default;
};
using Cubic = Bernstein<3>;

struct Crossing {
  double at = 0;        ///< 0..1
  bool rising = false;  ///< from below 0 to above
};

/// In ascending order, by turns rising and falling.
template <int degree>
struct Crossings {
  std::array<Crossing, degree> all{};
  std::size_t count = 0;

  const Crossing* begin() const { return all.data(); }
  const Crossing* end() const { return all.data() + count; }
};

// Degrees 1 to 6, each compiled once in bernstein.cpp.

struct ValueAndSlope {
  double value, slope;
};
template <int degree>
ValueAndSlope valueAndSlope(const Bernstein<degree>& p, double s);

/// The part up to s and the part from s on, each over 0..1 again.
template <int degree>
std::pair<Bernstein<degree>, Bernstein<degree>> split(const Bernstein<degree>& p, double s);

/// All crossings from a little before `after` on; earlier ones may be left out, the others do not depend on it.
/// Touching 0 is none: two that have nothing but rounding between them.
template <int degree>
Crossings<degree> findCrossings(const Bernstein<degree>& p, double after = 0);

/// The part from one place to another, which may be the same, and may lie a little outside.
Cubic partOf(const Cubic& p, double from, double to);

/// The least and the greatest value over 0..1, exact.
std::pair<double, double> rangeOf(const Cubic& p);

/// The coefficients of sum g[i][j] B_i(s) B_j(s): a cubic in two variables along a line.
Bernstein<6> alongDiagonal(const std::array<Cubic, 4>& g);

}  // namespace anamorph
