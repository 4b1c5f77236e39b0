// The 3D view as a whole: when it draws, that it draws the same twice, and that nothing upsets it.

#include <cmath>
#include <limits>

#include "geometry/shapes.h"
#include "shapes.h"
#include "viewport/viewport_fixture.h"

namespace anamorph::test {
namespace {

using View = GlTest;

const LevelResult& cylinder() {
  return finishedLevel("2-cylinder");
}

TEST_F(View, DrawsOnlyWhatIsMissing) {
  Viewport viewport;
  ViewportInput input = startInput(cylinder(), 40, 30);
  EXPECT_FALSE(viewport.complete());
  EXPECT_TRUE(viewport.draw(input, 1, 1, 4));
  EXPECT_FALSE(viewport.complete());
  EXPECT_TRUE(viewport.draw(input, 1, 2, 4));
  EXPECT_TRUE(viewport.draw(input, 1, 2, 4));
  EXPECT_TRUE(viewport.complete());
  EXPECT_FALSE(viewport.draw(input, 1, 1, 4));
  EXPECT_FALSE(viewport.draw(input, 1, 1, 2));
  EXPECT_TRUE(viewport.draw(input, 1, 8, 8)) << "more are wanted now";
  EXPECT_TRUE(viewport.complete());
  EXPECT_TRUE(viewport.draw(input, 0.5, 1, 8)) << "another scale";
  EXPECT_FALSE(viewport.complete());
  input.pose.eye.x += 1;
  EXPECT_TRUE(viewport.draw(input, 0.5, 8, 8));
  EXPECT_TRUE(viewport.complete());
}

TEST_F(View, StartsAnewWhenTheInputChanges) {
  Viewport viewport;
  ViewportInput input = startInput(cylinder());
  const Bitmap first = pictureOf(viewport, input, 4);
  ViewportInput other = input;
  other.pose.eye.z += 3;
  const Bitmap second = pictureOf(viewport, other, 4);
  EXPECT_NE(first, second);
  EXPECT_EQ(pictureOf(viewport, input, 4), first);
  EXPECT_EQ(pictureOf(input, 4), first) << "another viewport";
}

TEST_F(View, StepsDoNotMatter) {
  const ViewportInput input = startInput(cylinder(), 80, 60);
  Viewport viewport;
  for (int i = 0; i < 5; ++i) viewport.draw(input, 1, 1, 5);
  EXPECT_EQ(viewport.readBack(), pictureOf(input, 5));
}

TEST_F(View, SamplesSmoothEdges) {
  const ViewportInput input = startInput(cylinder());
  const Bitmap one = pictureOf(input, 1), many = pictureOf(input, 24);
  const BitmapDifference difference = compare(one, many, 24);
  EXPECT_GT(difference.fractionOver, 0.002);
  EXPECT_LT(difference.fractionOver, 0.1);
}

TEST_F(View, ScaleMakesAPictureOfAnotherSize) {
  Viewport viewport;
  const ViewportInput input = startInput(cylinder(), 101, 51);
  const Bitmap half = pictureOf(viewport, input, 1, 0.5);
  EXPECT_EQ(half.width, 51);
  EXPECT_EQ(half.height, 26);
  EXPECT_NE(viewport.texture(), 0u);
}

TEST_F(View, SizesFromOnePixelTo4K) {
  Viewport viewport;
  for (const auto& [width, height] : {std::pair{1, 1}, {3840, 2160}, {7, 300}, {1, 1}}) {
    const Bitmap picture = pictureOf(viewport, startInput(cylinder(), width, height));
    EXPECT_EQ(picture.width, width);
    EXPECT_EQ(picture.height, height);
    EXPECT_EQ(count(picture, [](const Rgba& c) { return c.a != 255; }), 0);
  }
}

TEST_F(View, NothingButTheInputDefaults) {
  ViewportInput input;
  input.width = 64;
  input.height = 48;
  const Bitmap picture = pictureOf(input);
  EXPECT_EQ(count(picture, [](const Rgba& c) { return c.a != 255; }), 0);
  EXPECT_GT(count(picture, [](const Rgba& c) { return c.r > 60; }), 1000);
}

TEST_F(View, EveryDisplaySettingDraws) {
  Viewport viewport;
  ViewportInput input = startInput(cylinder(), 48, 36);
  input.lines = std::make_shared<const std::vector<Line>>(1, Line{{0, -9, 9}, {0, -3, 5}});
  for (const char* name : {"1-plane", "2-cylinder", "3-sphere"}) {
    input.level = finishedLevel(name).level;
    for (int i = 0; i < 3 << 8; i += 5) {
      DisplaySettings& display = input.display;
      const auto bit = [&](int b) { return ((i >> b) & 1) != 0; };
      display.originalLook = static_cast<OriginalLook>(i >> 8);
      display.originalInMirror = bit(0);
      display.sculpture = bit(1);
      display.wireframe = bit(2);
      display.statusColors = bit(3);
      display.rtCamera = bit(4);
      display.lightMarkers = bit(5);
      input.transparent = bit(6);
      input.pose.orthographic = bit(7);
      input.selection.part = static_cast<Part>(i % 7);
      ASSERT_TRUE(viewport.draw(input, 1, 1, 1));
      ASSERT_EQ(takeGlErrors(), "") << i;
    }
  }
}

TEST_F(View, SurvivesNonsense) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   inf = std::numeric_limits<double>::infinity();
  const ViewportInput good = startInput(cylinder(), 32, 24);
  std::vector<ViewportInput> inputs(15, good);
  inputs[0].pose.eye.x = nan;
  inputs[1].pose.target = inputs[1].pose.eye;
  inputs[2].pose.up = {0, 0, 0};
  inputs[3].pose.eye = {1e200, 0, 0};
  inputs[4].pose.fovDegrees = inf;
  inputs[5].level.optic.shape() = SphereMirror{{0, 0, 0}, -1};
  inputs[6].level.optic.shape() = CylinderMirror{{0, 0, 0}, {0, 0, nan}, 1};
  inputs[7].level.optic.shape() = SphereMirror{{0, 0, 0}, 1e30};
  inputs[8].level.camera.eye = {nan, inf, 0};
  inputs[9].level.lights.assign(100, PointLight{{nan, 0, 3}, Color(inf), 1e300});
  inputs[10].level.camera = Camera{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0};
  inputs[10].level.grid = {0, 0, nan};
  inputs[11].pose = {{0.5, 0, 4}, {0, 0, 4}, {0, 0, 1}, 100, false};  // in the mirror
  inputs[12].level.camera.fovDegrees = nan;
  inputs[13] = inputs[9];
  inputs[13].selection = {Part::light, 2};
  inputs[14] = inputs[13];
  inputs[14].pose.orthographic = true;
  Viewport viewport;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_NO_THROW(viewport.draw(inputs[i], 1, 2, 2));
    EXPECT_EQ(takeGlErrors(), "");
    EXPECT_EQ(count(viewport.readBack(), [](const Rgba& c) { return c.a != 255; }), 0);
  }
  EXPECT_EQ(pictureOf(viewport, good), pictureOf(good)) << "nothing is left behind";
}

TEST_F(View, ManyLightsAreReported) {
  Viewport viewport;
  ViewportInput input = startInput(cylinder(), 16, 12);
  pictureOf(viewport, input);
  EXPECT_EQ(viewport.problem(), "");
  input.level.lights.assign(40, PointLight{});
  pictureOf(viewport, input);
  EXPECT_NE(viewport.problem(), "");
}

TEST_F(View, LeavesTheCallersFramebufferAlone) {
  const ViewportInput input = startInput(cylinder(), 20, 20);
  Viewport viewport;
  const Bitmap first = pictureOf(viewport, input);
  EXPECT_EQ(viewport.readBack(), first);
}

}  // namespace
}  // namespace anamorph::test
