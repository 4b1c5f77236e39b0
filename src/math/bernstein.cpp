#include "math/bernstein.h"

#include <algorithm>
#include <cmath>

#include "math/quadratic.h"

namespace anamorph {
namespace {

// Not 1/2: symmetric scenes have their crossings there.
constexpr double splitAt = 0.492;

// Crossings nearer to each other than this are a touch.
constexpr double touchingGap = 1e-12;

// Of the largest coefficient: values this small may as well be 0.
constexpr double rounding = 1e-15;

constexpr double binomial(int n, int k) {
  double value = 1;
  for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
  return value;
}

template <int n>
constexpr auto binomials = [] {
  std::array<double, n + 1> row{};
  for (int k = 0; k <= n; ++k) row[static_cast<std::size_t>(k)] = binomial(n, k);
  return row;
}();

double mix(double a, double b, double s) {
  return a + s * (b - a);
}

template <int degree>
int signChanges(const Bernstein<degree>& p) {
  int changes = 0;
  for (std::size_t i = 0; i < degree; ++i) changes += (p.c[i] < 0) != (p.c[i + 1] < 0);
  return changes;
}

// The one crossing between low and high, which the values at both ends lead to.
template <int degree>
double refine(const Bernstein<degree>& p, double low, double high, bool rising, double first) {
  constexpr double smallStep = 1e-12;  // after which Newton's next one is below rounding
  double s = first;
  for (int i = 0; i < 100; ++i) {
    const auto [value, slope] = valueAndSlope(p, s);
    if (value == 0) return s;
    ((value > 0) == rising ? high : low) = s;
    const double step = value / slope, next = s - step;
    const bool leadsThere = (slope > 0) == rising && next >= low && next <= high;
    if (leadsThere && std::abs(step) < smallStep) return next;
    s = leadsThere ? next : 0.5 * (low + high);
  }
  return s;
}

template <int degree>
void collectCrossings(const Bernstein<degree>& whole, const Bernstein<degree>& part, double from, double to,
                      double after, Crossings<degree>& found) {
  const int changes = signChanges(part);
  if (changes == 0 || to < after) return;
  if (changes == 1 || to - from < touchingGap) {
    const double first = part.c[0], last = part.c[degree];
    if ((first < 0) == (last < 0) || found.count == degree) return;
    const bool rising = first < 0;
    const double guess = from + (to - from) * first / (first - last);
    found.all[found.count++] = {refine(whole, from, to, rising, guess), rising};
    return;
  }
  const auto [left, right] = split(part, splitAt);
  const double middle = mix(from, to, splitAt);
  collectCrossings(whole, left, from, middle, after, found);
  collectCrossings(whole, right, middle, to, after, found);
}

// Where two crossings have no more than rounding between them, 0 was only touched.
template <int degree>
void removeTouches(const Bernstein<degree>& p, Crossings<degree>& found) {
  double largest = 0;
  for (const double c : p.c) largest = std::max(largest, std::abs(c));
  std::size_t kept = 0;
  for (std::size_t i = 0; i < found.count; ++i) {
    const bool isPair = i + 1 < found.count;
    const double middle = isPair ? 0.5 * (found.all[i].at + found.all[i + 1].at) : 0;
    if (isPair && std::abs(valueAndSlope(p, middle).value) < rounding * largest) {
      ++i;
    } else {
      found.all[kept++] = found.all[i];
    }
  }
  found.count = kept;
}

}  // namespace

// Horner's scheme in both s and 1 - s.
template <int degree>
ValueAndSlope valueAndSlope(const Bernstein<degree>& p, double s) {
  const double u = 1 - s;
  double value = p.c[0], slope = p.c[1] - p.c[0], power = 1;
#pragma GCC unroll 6
  for (std::size_t i = 1; i < degree; ++i) {
    power *= s;
    value = value * u + binomials<degree>[i] * power * p.c[i];
    slope = slope * u + binomials<degree - 1>[i] * power * (p.c[i + 1] - p.c[i]);
  }
  return {value * u + power * s * p.c[degree], degree * slope};
}

template <int degree>
std::pair<Bernstein<degree>, Bernstein<degree>> split(const Bernstein<degree>& p, double s) {
  Bernstein<degree> left, right = p;
  left.c[0] = p.c[0];
#pragma GCC unroll 6
  for (std::size_t n = degree; n > 0; --n) {
#pragma GCC unroll 6
    for (std::size_t i = 0; i < n; ++i) right.c[i] = mix(right.c[i], right.c[i + 1], s);
    left.c[degree + 1 - n] = right.c[0];
  }
  return {left, right};
}

template <int degree>
Crossings<degree> findCrossings(const Bernstein<degree>& p, double after) {
  constexpr double aLittle = 1e-6;  // more than two crossings are apart that are a touch
  Crossings<degree> found;
  collectCrossings(p, p, 0, 1, after - aLittle, found);
  if (found.count > 1) removeTouches(p, found);
  return found;
}

Cubic partOf(const Cubic& p, double a, double b) {
  // The polar form: how often each end enters tells the coefficient.
  const std::array onceA{mix(p.c[0], p.c[1], a), mix(p.c[1], p.c[2], a), mix(p.c[2], p.c[3], a)};
  const std::array onceB{mix(p.c[0], p.c[1], b), mix(p.c[1], p.c[2], b), mix(p.c[2], p.c[3], b)};
  const std::array twiceA{mix(onceA[0], onceA[1], a), mix(onceA[1], onceA[2], a)};
  const std::array both{mix(onceA[0], onceA[1], b), mix(onceA[1], onceA[2], b)};
  const std::array twiceB{mix(onceB[0], onceB[1], b), mix(onceB[1], onceB[2], b)};
  return {{mix(twiceA[0], twiceA[1], a), mix(twiceA[0], twiceA[1], b), mix(both[0], both[1], b),
           mix(twiceB[0], twiceB[1], b)}};
}

std::pair<double, double> rangeOf(const Cubic& p) {
  double least = std::min(p.c[0], p.c[3]), greatest = std::max(p.c[0], p.c[3]);
  const double first = p.c[1] - p.c[0], second = p.c[2] - p.c[1], third = p.c[3] - p.c[2];
  const auto turns = solveAnyQuadratic(first - 2 * second + third, second - first, first);
  if (!turns) return {least, greatest};
  for (const double s : {turns->first, turns->second}) {
    if (!(s > 0 && s < 1)) continue;
    const double value = valueAndSlope(p, s).value;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  return {least, greatest};
}

Bernstein<6> alongDiagonal(const std::array<Cubic, 4>& g) {
  constexpr auto one = binomials<3>;
  constexpr auto both = binomials<6>;
  Bernstein<6> p;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) p.c[i + j] += one[i] * one[j] * g[i].c[j];
  }
  for (std::size_t k = 0; k <= 6; ++k) p.c[k] *= 1 / both[k];
  return p;
}

#define ANAMORPH_BERNSTEIN(n)                                                           \
  template ValueAndSlope valueAndSlope<n>(const Bernstein<n>&, double);                 \
  template std::pair<Bernstein<n>, Bernstein<n>> split<n>(const Bernstein<n>&, double); \
  template Crossings<n> findCrossings<n>(const Bernstein<n>&, double)
ANAMORPH_BERNSTEIN(1);
ANAMORPH_BERNSTEIN(2);
ANAMORPH_BERNSTEIN(3);
ANAMORPH_BERNSTEIN(4);
ANAMORPH_BERNSTEIN(5);
ANAMORPH_BERNSTEIN(6);

}  // namespace anamorph
