#include "edit/control_points.h"

#include <algorithm>

#include <glm/common.hpp>

#include "base/check.h"

namespace anamorph {
namespace {

// at(i) of `from` values, at place `number` of `count`.
template <typename At>
auto between(const At& at, std::size_t from, std::size_t number, std::size_t count) {
  const double place = static_cast<double>(number * (from - 1)) / static_cast<double>(count - 1);
  const std::size_t before = std::min(static_cast<std::size_t>(place), from - 2);
  return glm::mix(at(before), at(before + 1), place - static_cast<double>(before));
}

template <typename Value>
std::vector<Value> resampledValues(const std::vector<Value>& values, std::size_t count) {
  CHECK(values.size() >= 2 && count >= 2);
  std::vector<Value> result;
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(between([&](std::size_t k) { return values[k]; }, values.size(), i, count));
  }
  return result;
}

}  // namespace

std::vector<double> resampled(const std::vector<double>& values, std::size_t count) {
  return resampledValues(values, count);
}

std::vector<CurvePoint> resampled(const std::vector<CurvePoint>& values, std::size_t count) {
  return resampledValues(values, count);
}

HeightGrid resampled(const HeightGrid& values, std::size_t rows, std::size_t columns) {
  CHECK(values.rows() >= 2 && values.columns >= 2 && rows >= 2 && columns >= 2);
  HeightGrid result{columns, {}};
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const auto inRow = [&](std::size_t r) {
        return between([&](std::size_t c) { return values.at(r, c); }, values.columns, column, columns);
      };
      result.heights.push_back(between(inRow, values.rows(), row, rows));
    }
  }
  return result;
}

}  // namespace anamorph
