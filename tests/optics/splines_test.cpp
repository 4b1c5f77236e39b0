// Rays at the mirrors of splines: revolution, extrusion and patch against searches by their definitions, and that none
// slips through between two pieces.

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "optics/random_splines.h"
#include "optics/shape.h"

namespace anamorph {
namespace {

using namespace testing;

constexpr double infinity = std::numeric_limits<double>::infinity();

// ---- The first hit by a dense search

// Where `gap` changes its sign between two of so many steps, by halving.
std::vector<double> denseRoots(const std::function<double(double)>& gap, double from, double to, int steps) {
  std::vector<double> roots;
  double before = from, valueBefore = gap(from);
  for (int i = 1; i <= steps; ++i) {
    const double here = from + (to - from) * i / steps, value = gap(here);
    if ((value < 0) != (valueBefore < 0)) {
      double low = before, high = here;
      for (int k = 0; k < 100; ++k) {
        const double middle = 0.5 * (low + high);
        ((gap(middle) < 0) == (valueBefore < 0) ? low : high) = middle;
      }
      roots.push_back(low);
    }
    before = here;
    valueBefore = value;
  }
  return roots;
}

struct Local {
  Point from;
  Vector along;
};
Local localOf(const Ray& ray, const Point& origin, const Axes& f) {
  const auto in = [&](const Vector& v) {
    return Vector(glm::dot(v, f[0]), glm::dot(v, f[1]), glm::dot(v, f[2]));
  };
  return {in(ray.origin - origin), in(ray.direction)};
}

constexpr int denseSteps = 3000;

double denseHit(const RevolutionMirror& mirror, const Ray& ray) {
  const auto [from, along] = localOf(ray, mirror.bottom, axesAlong(mirror.axis()));
  double low = 0, high = 20;
  const double a = -from.z / along.z, b = (mirror.height() - from.z) / along.z;
  low = std::max(low, std::min(a, b));
  high = std::min(high, std::max(a, b));
  if (!(low < high)) return infinity;
  const auto gap = [&](double t) {
    const Point p = from + t * along;
    return std::hypot(p.x, p.y) - radiusByDefinition(mirror, p.z);
  };
  const auto roots = denseRoots(gap, low, high, denseSteps);
  return roots.empty() ? infinity : roots.front();
}

Axes frameOf(const Vector& z, const Vector& across) {
  const Direction k = glm::normalize(z), i = glm::normalize(across - glm::dot(across, k) * k);
  return {i, glm::cross(k, i), k};
}

double denseHit(const ExtrusionMirror& mirror, const Ray& ray) {
  const auto [from, along] = localOf(ray, mirror.origin, frameOf(mirror.axis, mirror.across));
  const double squared = along.x * along.x + along.y * along.y;
  const int m = static_cast<int>(mirror.points.size());
  const auto beside = [&](double u) {
    const CurvePoint p = curveByDefinition(mirror, u);
    return (p.x - from.x) * along.y - (p.y - from.y) * along.x;
  };
  double first = infinity;
  for (const double u : denseRoots(beside, 0, mirror.closed ? m : m - 3, denseSteps)) {
    const CurvePoint p = curveByDefinition(mirror, u);
    const double t = ((p.x - from.x) * along.x + (p.y - from.y) * along.y) / squared,
                 z = from.z + t * along.z;
    if (t > 0 && z >= 0 && z <= mirror.height) first = std::min(first, t);
  }
  return first;
}

double denseHit(const PatchMirror& mirror, const Ray& ray) {
  const Direction x = glm::normalize(mirror.across),
                  y = glm::normalize(mirror.up - glm::dot(mirror.up, x) * x);
  const auto [from, along] = localOf(ray, mirror.origin, {x, y, glm::cross(x, y)});
  double low = 0, high = 20;
  for (int k = 0; k < 2; ++k) {
    const double a = -from[k] / along[k], b = (mirror.size[std::size_t(k)] - from[k]) / along[k];
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
  if (!(low < high)) return infinity;
  const auto gap = [&](double t) {
    const Point p = from + t * along;
    return p.z - heightByDefinition(mirror, p.x, p.y);
  };
  const auto roots = denseRoots(gap, low, high, denseSteps);
  return roots.empty() ? infinity : roots.front();
}

double denseHit(const Shape& shape, const Ray& ray) {
  if (const auto* mirror = shape.as<RevolutionMirror>()) return denseHit(*mirror, ray);
  if (const auto* mirror = shape.as<ExtrusionMirror>()) return denseHit(*mirror, ray);
  return denseHit(shapeAs<PatchMirror>(shape), ray);
}

// Off the surface by definition.
double offSurface(const Shape& shape, const Point& p) {
  if (const auto* mirror = shape.as<RevolutionMirror>()) {
    const Point at = localOf({p, {}}, mirror->bottom, axesAlong(mirror->axis())).from;
    return std::hypot(at.x, at.y) - radiusByDefinition(*mirror, at.z);
  }
  if (const auto* mirror = shape.as<PatchMirror>()) {
    const Direction x = glm::normalize(mirror->across),
                    y = glm::normalize(mirror->up - glm::dot(mirror->up, x) * x);
    const Point at = localOf({p, {}}, mirror->origin, {x, y, glm::cross(x, y)}).from;
    return at.z - heightByDefinition(*mirror, at.x, at.y);
  }
  const auto& mirror = shapeAs<ExtrusionMirror>(shape);
  const Point at = localOf({p, {}}, mirror.origin, frameOf(mirror.axis, mirror.across)).from;
  const int m = static_cast<int>(mirror.points.size());
  double nearest = infinity;
  for (int i = 0; i <= 20000; ++i) {
    const CurvePoint on = curveByDefinition(mirror, (mirror.closed ? m : m - 3) * i / 20000.0);
    nearest = std::min(nearest, std::hypot(on.x - at.x, on.y - at.y));
  }
  return nearest < 1e-2 ? 0 : nearest;  // as near as the steps are
}

TEST(Splines, FirstHitIsTheDenseSearchs) {
  int hits = 0, misses = 0, grazes = 0;
  for (unsigned seed = 0; seed < 3600; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Shape shape = randomSpline(int(seed), random);
    const Box box = boxOf(shape);
    const Point eye = randomEye(shape, random);
    const Point aim = box.centre() + random.uniform(0, 0.5) * box.diagonal() * random.direction();
    const Ray ray{eye, aim - eye};
    const auto hit = intersect(shape, ray);
    const double dense = denseHit(shape, ray);
    if (hit && hit->t < dense - 1e-9) {  // two crossings between two steps of the search
      ++grazes;
      EXPECT_LT(std::abs(offSurface(shape, hit->point)), 1e-11);
      continue;
    }
    if (!hit && dense == infinity) {
      ++misses;
      continue;
    }
    ++hits;
    ASSERT_TRUE(hit) << "the search meets it at " << dense;
    EXPECT_NEAR(hit->t, dense, 1e-9);
    EXPECT_NEAR(glm::length(hit->normal), 1, 1e-14);
    EXPECT_LE(glm::dot(hit->normal, ray.direction), 0);
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(misses, 300);
  EXPECT_LT(grazes, 30);
}

// ---- No ray slips through between two pieces, and none is told of one crossing twice

// A knot, or now and then any place; not on the border.
double knotOr(Random& random, int spans, bool closed) {
  if (random.integer(0, 3) == 0 || (spans < 2 && !closed)) return random.uniform(0.01, 0.99);
  return closed ? double(random.integer(0, spans)) / spans : double(random.integer(1, spans - 1)) / spans;
}

Aim aimAtKnots(const Shape& shape, Random& random) {
  if (const auto* mirror = shape.as<RevolutionMirror>()) {
    return aimAt(shape, random.uniform(0, 1), knotOr(random, int(mirror->radii.size()) - 3, false));
  }
  if (const auto* mirror = shape.as<ExtrusionMirror>()) {
    const int m = int(mirror->points.size());
    return aimAt(shape, knotOr(random, mirror->closed ? m : m - 3, mirror->closed),
                 random.uniform(0.01, 0.99));
  }
  const auto& mirror = shapeAs<PatchMirror>(shape);
  return aimAt(shape, knotOr(random, int(mirror.heights.columns) - 3, false),
               knotOr(random, int(mirror.heights.rows()) - 3, false));
}

class SplineRays : public ::testing::TestWithParam<int> {};

TEST_P(SplineRays, DoNotLeakAtKnots) {
  constexpr unsigned shapes = 1000, raysAShape = 1000;
  int leaks = 0, twice = 0;
  for (unsigned seed = 0; seed < shapes; ++seed) {
    Random random(seed);
    const Shape shape = randomSpline(GetParam(), random);
    const double size = boxOf(shape).diagonal();
    for (unsigned i = 0; i < raysAShape; ++i) {
      const Aim aim = aimAtKnots(shape, random);
      const Direction way = wayTo(aim, random);
      const double distance = size * random.uniform(0.1, 3);
      const Ray ray{aim.point - distance * way, distance * way};
      int there = 0;
      double t = 0.5;
      for (auto hit = intersect(shape, ray, t); hit; hit = intersect(shape, ray, t)) {
        ASSERT_GT(hit->t, t) << "seed " << seed;
        t = hit->t;
        there += std::abs(t - 1) < 1e-9;
        if (t > 1.01) break;
      }
      leaks += there == 0;
      twice += there > 1;
      if (there != 1 && leaks + twice < 5)
        ADD_FAILURE() << "seed " << seed << ", ray " << i << ": met " << there;
    }
  }
  EXPECT_EQ(leaks, 0);
  EXPECT_EQ(twice, 0);
}
constexpr const char* splineNames[] = {"revolution", "extrusion", "patch"};
INSTANTIATE_TEST_SUITE_P(All, SplineRays, ::testing::Values(0, 1, 2),
                         [](const auto& kind) { return std::string(splineNames[kind.param]); });

TEST(Splines, WhetherItIsMetBetweenTwoWaysIsWhatTheHitsSay) {
  int meets = 0, free = 0;
  for (unsigned seed = 0; seed < 6000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Shape shape = randomSpline(int(seed), random);
    const Point eye = randomEye(shape, random),
                aim = pointAt(shape, random.uniform(0, 1), random.uniform(0, 1));
    const Ray ray{eye, aim - eye};
    const auto leaving = intersect(shape, ray);
    if (!leaving) continue;
    const Vector out = random.direction() * boxOf(shape).diagonal();
    const Ray onward{leaving->point, glm::dot(out, leaving->normal) < 0 ? -out : out};
    if (glm::dot(onward.direction, leaving->normal) < 0.02 * glm::length(onward.direction)) continue;
    for (const auto& [way, from] : {std::pair{onward, 1e-9}, std::pair{ray, 0.0}}) {
      const double to = random.uniform(0.01, 2);
      const auto hit = intersect(shape, way, from);
      const bool expected = hit && hit->t < to;
      ++(expected ? meets : free);
      EXPECT_EQ(meetsBetween(shape, way, from, to), expected);
    }
  }
  EXPECT_GT(meets, 500);
  EXPECT_GT(free, 500);
}

TEST(Splines, AskingOnFromAHitGivesTheNextOne) {
  for (unsigned seed = 0; seed < 600; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Shape shape = randomSpline(int(seed), random);
    const Point eye = randomEye(shape, random), aim = boxOf(shape).centre() + random.point(1);
    const Ray ray{eye, aim - eye};
    std::vector<double> forwards;
    for (auto hit = intersect(shape, ray); hit; hit = intersect(shape, ray, hit->t)) {
      forwards.push_back(hit->t);
      ASSERT_LT(forwards.size(), 200u);
    }
    // From between two hits the later one is the same to the bit.
    for (std::size_t i = 1; i < forwards.size(); ++i) {
      EXPECT_GT(forwards[i], forwards[i - 1] + 1e-12);
      const auto hit = intersect(shape, ray, 0.5 * (forwards[i - 1] + forwards[i]));
      ASSERT_TRUE(hit);
      EXPECT_EQ(hit->t, forwards[i]);
    }
    // And seen from behind they are the same.
    const Ray back{eye + 2.0 * ray.direction, -ray.direction};
    std::size_t i = forwards.size();
    for (auto hit = intersect(shape, back, -infinity); hit; hit = intersect(shape, back, hit->t)) {
      if (hit->t >= 2) break;
      while (i > 0 && forwards[i - 1] >= 2) --i;
      ASSERT_GT(i, 0u);
      EXPECT_NEAR(2 - hit->t, forwards[--i], 1e-9);
    }
  }
}

TEST(Splines, AFarEyeLosesOnlyItsOwnDigits) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Shape shape = randomSpline(int(seed), random);
    const Aim aim = aimAtKnots(shape, random);
    const Direction way = wayTo(aim, random);
    const double far = 1e5 * boxOf(shape).diagonal();
    const Ray ray{aim.point - far * way, far * way};
    double nearest = infinity;
    for (auto hit = intersect(shape, ray); hit; hit = intersect(shape, ray, hit->t))
      nearest = std::min(nearest, std::abs(hit->t - 1));
    EXPECT_LT(nearest, 1e-13) << "in lengths of the ray";
  }
}

}  // namespace
}  // namespace anamorph
