#include "raytrace/image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "base/check.h"

namespace anamorph {
namespace {

Bitmap bitmapOf(int width, int height, std::vector<std::uint8_t> bytes) {
  return {width, height, 3, std::move(bytes)};
}

TEST(Image, StartsBlackAndCountsFromTheTopLeft) {
  Image image(3, 2);
  EXPECT_EQ(image.pixels, std::vector<glm::vec3>(6, glm::vec3(0)));
  image.at(2, 1) = glm::vec3(1);
  EXPECT_EQ(image.pixels[5], glm::vec3(1));
}

TEST(Image, NegativeSizesAreProgrammingErrors) {
  EXPECT_THROW(Image(-1, 2), ProgrammingError);
}

TEST(ToDisplay, IsSrgbBelowTheShoulder) {
  EXPECT_EQ(toDisplay(0), 0);
  EXPECT_NEAR(toDisplay(0.002f), 0.02584f, 1e-6);
  EXPECT_NEAR(toDisplay(0.2140f), 0.5f, 1e-3);
  EXPECT_NEAR(toDisplay(0.5f), 0.7354f, 1e-4);
}

TEST(ToDisplay, RisesWithoutEverPassingOne) {
  float last = -1;
  for (float x = 0; x < 4; x += 0.001f) {
    const float y = toDisplay(x);
    ASSERT_GE(y, last) << x;
    ASSERT_LT(y, last < 0 ? 1.f : last + 0.02f) << "a jump at " << x;
    ASSERT_LE(y, 1) << x;
    last = y;
  }
  EXPECT_GT(last, 0.99f);
  EXPECT_NEAR(toDisplay(std::numeric_limits<float>::infinity()), 1, 1e-6);
}

TEST(ToDisplay, WhatIsNoLightIsBlack) {
  EXPECT_EQ(toDisplay(-1), 0);
  EXPECT_EQ(toDisplay(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(LightShownAs, IsTheWayBackFromEveryByte) {
  for (std::uint32_t byte = 0; byte <= 255; ++byte) {
    Image image(1, 1);
    image.at(0, 0) = lightShownAs(Rgb{byte << 16 | (255 - byte) << 8 | byte});
    const auto b = static_cast<std::uint8_t>(byte);
    EXPECT_EQ(toBitmap(image), bitmapOf(1, 1, {b, static_cast<std::uint8_t>(255 - byte), b}));
  }
}

TEST(ToBitmap, RoundsEveryChannel) {
  Image image(2, 1);
  image.at(0, 0) = {0, 0.5f, 100};
  image.at(1, 0) = {0.0015f, 0.2140f, -1};
  EXPECT_EQ(toBitmap(image), bitmapOf(2, 1, {0, 188, 255, 5, 127, 0}));
}

TEST(CompareBitmaps, CountsPixelsOverTheThreshold) {
  const Bitmap a = bitmapOf(2, 2, {0, 0, 0, 10, 10, 10, 20, 20, 20, 30, 30, 30});
  const Bitmap b = bitmapOf(2, 2, {0, 0, 0, 10, 13, 10, 20, 20, 16, 30, 30, 30});
  const BitmapDifference difference = compare(a, b, 3);
  EXPECT_NEAR(difference.meanAbsolute, 7.0 / 12, 1e-15);
  EXPECT_EQ(difference.maxAbsolute, 4);
  EXPECT_EQ(difference.fractionOver, 0.25);
  EXPECT_EQ(compare(a, a, 0).fractionOver, 0);
  EXPECT_EQ(compare(Bitmap{}, Bitmap{}, 0).meanAbsolute, 0);
}

}  // namespace
}  // namespace anamorph
