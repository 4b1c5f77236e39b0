#include "math/uniform_spline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace anamorph {

Cubic splineSpan(double c0, double c1, double c2, double c3) {
  return {{(c0 + 4 * c1 + c2) / 6, (2 * c1 + c2) / 3, (c1 + 2 * c2) / 3, (c1 + 4 * c2 + c3) / 6}};
}

namespace {

std::size_t countSpans(std::size_t controls, bool closed) {
  if (controls < (closed ? fewestClosedControls : fewestOpenControls)) return 0;
  return closed ? controls : controls - 3;
}

Cubic spanOf(std::span<const double> c, std::size_t i) {
  const std::size_t m = c.size();
  return splineSpan(c[i], c[(i + 1) % m], c[(i + 2) % m], c[(i + 3) % m]);
}

}  // namespace

std::vector<Cubic> splineSpans(std::span<const double> controls, bool closed) {
  std::vector<Cubic> spans;
  for (std::size_t i = 0; i < countSpans(controls.size(), closed); ++i) spans.push_back(spanOf(controls, i));
  return spans;
}

ValueAndSlope splineAt(std::span<const double> controls, double u) {
  const double last = static_cast<double>(countSpans(controls.size(), false)) - 1;
  const double span = std::clamp(std::floor(u), 0.0, last);
  return valueAndSlope(spanOf(controls, static_cast<std::size_t>(span)), u - span);
}

std::pair<double, double> rangeOf(std::span<const Cubic> spans) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::pair range{infinity, -infinity};
  for (const Cubic& span : spans) {
    const auto [least, greatest] = rangeOf(span);
    range = {std::min(range.first, least), std::max(range.second, greatest)};
  }
  return range;
}

}  // namespace anamorph
