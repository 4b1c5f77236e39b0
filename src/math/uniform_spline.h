// Uniform cubic B-splines: smooth curves (C2, so that what they reflect has no kinks) that control values pull towards
// themselves without being met. Between two knots the curve is one cubic; the knots are at 0, 1, 2, ...
//
//   open    m control values, m - 3 spans        closed    m control values, m spans, and round again
//
//   span i, u in 0..1:  ((1-u)^3 c0 + (3u^3-6u^2+4) c1 + (-3u^3+3u^2+3u+1) c2 + u^3 c3) / 6   of c[i], c[i+1], ...
#pragma once

#include <span>
#include <vector>

#include "math/bernstein.h"

namespace anamorph {

constexpr std::size_t fewestOpenControls = 4, fewestClosedControls = 3;

/// One span of four control values.
Cubic splineSpan(double c0, double c1, double c2, double c3);

/// All spans in order; none for too few control values.
std::vector<Cubic> splineSpans(std::span<const double> controls, bool closed = false);

/// Of an open one at u, from 0 to the number of spans, the ends included; `slope` is the derivative by u.
ValueAndSlope splineAt(std::span<const double> controls, double u);

/// The least and the greatest value, exact.
std::pair<double, double> rangeOf(std::span<const Cubic> spans);

}  // namespace anamorph
