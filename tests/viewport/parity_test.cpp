// The 3D view from the RT camera's place is the tracer's picture: two programs in two languages, one in
// double and one in float, that have to agree.

#include "raytrace/scene_hit.h"
#include "viewport/viewport_fixture.h"

namespace anamorph::test {
namespace {

class Parity : public GlTest, public testing::WithParamInterface<const char*> {};

struct Difference {
  double meanAbsolute = 0;    // of all channels, 0..255
  double fractionOver16 = 0;  // of pixels
  int pixels = 0;
};

using Pick = std::function<bool(int x, int y)>;

Difference differenceOf(const Bitmap& view, const Bitmap& traced, const Pick& pick) {
  Difference d;
  double sum = 0;
  int over = 0;
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      if (!pick(x, y)) continue;
      ++d.pixels;
      const Rgba seen = at(view, x, y);
      const int channels[] = {seen.r, seen.g, seen.b};
      int largest = 0;
      for (int c = 0; c < 3; ++c) {
        const int other = traced.bytes[3 * (static_cast<std::size_t>(y) * view.width + x) + c];
        const int difference = std::abs(channels[c] - other);
        sum += difference;
        largest = std::max(largest, difference);
      }
      over += largest > 16;
    }
  }
  if (d.pixels > 0) {
    d.meanAbsolute = sum / (3.0 * d.pixels);
    d.fractionOver16 = static_cast<double>(over) / d.pixels;
  }
  return d;
}

Bitmap tracedPicture(const LevelResult& finished, int width, int height) {
  ImageRequest request = makeImageRequest(finished.level, width, height, 0);
  request.samplesPerAxis = 1;
  return toBitmap(*makePicture(finished, PictureKind::reflection, request));
}

/// Whether the mirror is the first thing that the tracer meets in a pixel.
Pick seesMirror(const LevelResult& finished, int width, int height) {
  const auto scene =
      std::make_shared<RenderScene>(buildScene(makeReflectionScene(finished.level, finished.sculpture)));
  const Projection projection(finished.level.camera, width, height);
  return [=](int x, int y) {
    const auto hit = findHit(*scene, projection.rayThrough({x + 0.5, y + 0.5}));
    return hit && hit->object.kind == ObjectKind::optic;
  };
}

TEST_P(Parity, MirrorShowsWhatTheTracerShows) {
  constexpr int size = 320;
  const LevelResult& finished = finishedLevel(GetParam());
  ViewportInput input = tracerInput(finished, size, size);
  input.display.rtCamera = true;  // not seen from within, and not to be noticed otherwise
  const Bitmap view = pictureOf(input);
  const Bitmap traced = tracedPicture(finished, size, size);
  const Difference mirror = differenceOf(view, traced, seesMirror(finished, size, size));
  EXPECT_GT(mirror.pixels, 5000);
  EXPECT_LE(mirror.meanAbsolute, 0.1);
  EXPECT_LE(mirror.fractionOver16, 0.0005);
  const Difference all = differenceOf(view, traced, [](int, int) { return true; });
  EXPECT_LE(all.meanAbsolute, 0.1);
  EXPECT_LE(all.fractionOver16, 0.0005);
}

// Seen from elsewhere, against a camera at that place.
TEST_P(Parity, HoldsFromTheStartOfTheView) {
  constexpr int width = 240, height = 160;
  LevelResult finished = finishedLevel(GetParam());
  const ViewSettings& view = finished.level.view;
  ViewportInput input = tracerInput(finished, width, height);
  input.pose = {view.eye, view.target, {0, 0, 1}, view.fovDegrees, false};
  finished.level.camera.eye = view.eye;
  finished.level.camera.target = view.target;
  finished.level.camera.fovDegrees = view.fovDegrees;
  const Difference all =
      differenceOf(pictureOf(input), tracedPicture(finished, width, height), [](int, int) { return true; });
  EXPECT_LE(all.meanAbsolute, 0.1);
  EXPECT_LE(all.fractionOver16, 0.001);
}

TEST_P(Parity, HoldsFarFromTheOrigin) {
  constexpr int size = 160;
  LevelResult finished = finishedLevel(GetParam());
  const Vector away(4000, -7000, 0);  // a multiple of the grid of the ground
  Level& level = finished.level;
  level.optic.shape() = mapShape(level.optic.shape(), {[&](const Point& p) { return p + away; }});
  for (Point* p : {&level.camera.eye, &level.camera.target, &level.original.placement.position}) *p += away;
  for (PointLight& light : level.lights) light.position += away;
  const auto shape = loadOriginal(level.original.shape, "");
  finished = *finishLevel(level, placeOriginal(*shape, level.original.unitize, level.original.placement), 0);
  const Bitmap view = pictureOf(tracerInput(finished, size, size));
  const Difference all =
      differenceOf(view, tracedPicture(finished, size, size), [](int, int) { return true; });
  EXPECT_LE(all.meanAbsolute, 0.6);
  EXPECT_LE(all.fractionOver16, 0.01);
}

// Many samples are the tracer's many samples, though at other places in the pixel.
TEST_P(Parity, ManySamplesGiveTheTracersSmoothPicture) {
  constexpr int size = 120;
  const LevelResult& finished = finishedLevel(GetParam());
  ImageRequest request = makeImageRequest(finished.level, size, size, 0);
  request.samplesPerAxis = 6;
  const Bitmap traced = toBitmap(*makePicture(finished, PictureKind::reflection, request));
  const Bitmap view = pictureOf(tracerInput(finished, size, size), 32);
  const Difference all = differenceOf(view, traced, [](int, int) { return true; });
  EXPECT_LE(all.meanAbsolute, 0.7);
  EXPECT_LE(all.fractionOver16, 0.003);
}

INSTANTIATE_TEST_SUITE_P(Levels, Parity, testing::Values("1-plane", "2-cylinder", "3-sphere"));

}  // namespace
}  // namespace anamorph::test
