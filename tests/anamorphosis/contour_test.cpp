#include "anamorphosis/contour.h"

#include <cmath>

#include <gtest/gtest.h>

#include "anamorphosis/outline.h"
#include "random_scene.h"

namespace anamorph {
namespace {

using namespace testing;

std::vector<Pixel> circle(const Pixel& middle, double radius, int count = 2000) {
  std::vector<Pixel> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    points.push_back(middle + radius * Pixel(std::cos(angle), std::sin(angle)));
  }
  return points;
}

TEST(ContourDistance, OfCirclesIsTheDifferenceOfTheirRadii) {
  for (const double difference : {0.0, 0.25, 1.5, 7.0}) {
    EXPECT_NEAR(contourDistance(circle({60, 50}, 30), circle({60, 50}, 30 + difference)), difference, 0.06);
  }
  EXPECT_EQ(contourDistance(circle({60, 50}, 30), circle({60, 50}, 50)), farthestContour);
}

TEST(ContourDistance, AsksBothWays) {
  std::vector<Pixel> more = circle({60, 50}, 30);
  for (const Pixel& point : circle({200, 50}, 5, 500)) more.push_back(point);
  EXPECT_EQ(contourDistance(circle({60, 50}, 30), more), farthestContour);
  EXPECT_EQ(contourDistance(more, circle({60, 50}, 30)), farthestContour);
}

TEST(ContourDistance, OfNothingIsFarFromSomething) {
  EXPECT_EQ(contourDistance({}, {}), 0);
  EXPECT_EQ(contourDistance(circle({9, 9}, 3), {}), farthestContour);
  EXPECT_EQ(contourDistance({}, circle({9, 9}, 3)), farthestContour);
}

TEST(ContourDistance, NearestPointIsFoundAsBySearchingAll) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto cloud = [&](int count) {
      std::vector<Pixel> points;
      for (int i = 0; i < count; ++i) points.push_back({random.uniform(-20, 20), random.uniform(-20, 20)});
      return points;
    };
    const auto one = cloud(1), many = cloud(30);
    double nearest = farthestContour;
    std::vector<double> ways;
    for (const Pixel& point : many) {
      nearest = std::min(nearest, glm::length(point - one[0]));
      ways.push_back(std::min(glm::length(point - one[0]), farthestContour));
    }
    ways.push_back(nearest);
    std::sort(ways.begin(), ways.end());
    EXPECT_EQ(contourDistance(one, many), ways[(ways.size() - 1) * 99 / 100]);
  }
}

// A picture of two disks, the original's and the reflection's.
struct Disks {
  Pixel original, reflection;
  double radius;
  PixelClass operator()(const Pixel& p) const {
    const bool a = glm::length(p - original) < radius, b = glm::length(p - reflection) < radius;
    return a ? (b ? PixelClass::both : PixelClass::onlyOriginal)
             : (b ? PixelClass::onlyReflection : PixelClass::background);
  }
};

double outlineDistance(const std::function<PixelClass(const Pixel&)>& classAt, int size) {
  std::vector<PixelClass> classes;
  for (int i = 0; i < size * size; ++i) classes.push_back(classAt({i % size + 0.5, i / size + 0.5}));
  const Outlines outlines = findOutlines(classes, size, size, classAt, 1, {});
  return contourDistance(outlines.original, outlines.reflection);
}

// A quarter of a pixel is what the outline is known to, however small the disk: the sentence that the share of pixels
// breaks.
TEST(Outlines, TellHowFarSilhouettesAreApartWhetherLargeOrSmall) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const double radius = seed % 2 == 0 ? random.uniform(2, 4) : random.uniform(20, 40);
    const double shift = random.uniform(0, 3), angle = random.uniform(0, 2 * pi);
    const Pixel middle{50 + random.uniform(-1, 1), 50 + random.uniform(-1, 1)};
    const Disks disks{middle, middle + shift * Pixel(std::cos(angle), std::sin(angle)), radius};
    EXPECT_NEAR(outlineDistance(disks, 100), shift, 0.36);
  }
}

TEST(Outlines, FollowTheOriginalWhereSomethingStandsInTheWay) {
  const Disks same{{50, 50}, {50, 50}, 30};
  const auto half = [&](PixelClass unseen) {
    return outlineDistance(
        [&](const Pixel& p) {
          const PixelClass kind = same(p);
          return kind == PixelClass::both && p.x < 50 ? unseen : kind;
        },
        100);
  };
  EXPECT_EQ(half(PixelClass::hidden), 0);
  EXPECT_EQ(half(PixelClass::missed), 0);
  EXPECT_EQ(half(PixelClass::onlyOriginal), farthestContour);
}

}  // namespace
}  // namespace anamorph
