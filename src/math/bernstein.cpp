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
    const double step = value / slope;
    const bool inside = s - step > low && s - step < high;
    const double next = inside ? s - step : 0.5 * (low + high);
    if (next == s || (inside && std::abs(step) < smallStep)) return next;
    s = next;
  }
  return s;
}

template <int degree>
void collectCrossings(const Bernstein<degree>& whole, const Bernstein<degree>& part, double from, double to,
                      Crossings<degree>& found) {
  const int changes = signChanges(part);
  if (changes == 0) return;
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
  collectCrossings(whole, left, from, middle, found);
  collectCrossings(whole, right, middle, to, found);
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

template <int degree>
Bernstein<degree> fromPowers(const std::array<double, degree + 1>& a) {
  Bernstein<degree> p;
  for (int k = 0; k <= degree; ++k) {
    for (int i = 0; i <= k; ++i) {
      p.c[static_cast<std::size_t>(k)] +=
          binomial(k, i) / binomial(degree, i) * a[static_cast<std::size_t>(i)];
    }
  }
  return p;
}

template <int degree>
ValueAndSlope valueAndSlope(const Bernstein<degree>& p, double s) {
  std::array<double, degree + 1> c = p.c;
  for (std::size_t n = degree; n > 1; --n) {
    for (std::size_t i = 0; i < n; ++i) c[i] = mix(c[i], c[i + 1], s);
  }
  return {mix(c[0], c[1], s), degree * (c[1] - c[0])};
}

template <int degree>
std::pair<Bernstein<degree>, Bernstein<degree>> split(const Bernstein<degree>& p, double s) {
  Bernstein<degree> left, right = p;
  left.c[0] = p.c[0];
  for (std::size_t n = degree; n > 0; --n) {
    for (std::size_t i = 0; i < n; ++i) right.c[i] = mix(right.c[i], right.c[i + 1], s);
    left.c[degree + 1 - n] = right.c[0];
  }
  return {left, right};
}

template <int degree>
Crossings<degree> findCrossings(const Bernstein<degree>& p) {
  Crossings<degree> found;
  collectCrossings(p, p, 0, 1, found);
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
  constexpr std::array third{1.0, 3.0, 3.0, 1.0};
  constexpr std::array sixth{1.0, 6.0, 15.0, 20.0, 15.0, 6.0, 1.0};
  Bernstein<6> p;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) p.c[i + j] += third[i] * third[j] / sixth[i + j] * g[i].c[j];
  }
  return p;
}

#define ANAMORPH_BERNSTEIN(n)                                                           \
  template Bernstein<n> fromPowers<n>(const std::array<double, n + 1>&);                \
  template ValueAndSlope valueAndSlope<n>(const Bernstein<n>&, double);                 \
  template std::pair<Bernstein<n>, Bernstein<n>> split<n>(const Bernstein<n>&, double); \
  template Crossings<n> findCrossings<n>(const Bernstein<n>&)
ANAMORPH_BERNSTEIN(1);
ANAMORPH_BERNSTEIN(2);
ANAMORPH_BERNSTEIN(3);
ANAMORPH_BERNSTEIN(4);
ANAMORPH_BERNSTEIN(5);
ANAMORPH_BERNSTEIN(6);

}  // namespace anamorph
