// How many control values a spline of the mirror has: with another number it keeps about the same form.
#pragma once

#include <cstddef>
#include <vector>

#include "optics/shape_fields.h"

namespace anamorph {

/// The values at `count` even places between the first and the last, joined by straight lines. `count` >= 2, of at least
/// two values.
std::vector<double> resampled(const std::vector<double>& values, std::size_t count);
std::vector<CurvePoint> resampled(const std::vector<CurvePoint>& values, std::size_t count);
HeightGrid resampled(const HeightGrid& values, std::size_t rows, std::size_t columns);

}  // namespace anamorph
