// The 3D view from the RT camera's place is the tracer's picture: two programs in two languages, one in
// double and one in float, that have to agree.

#include "raytrace/scene_hit.h"
#include "raytrace/tracer.h"
#include "shapes.h"
#include "viewport/viewport_fixture.h"

namespace anamorph::test {
namespace {

using CanvasParity = GlTest;

class Parity : public GlTest, public testing::WithParamInterface<const char*> {};

struct Difference {
  double meanAbsolute = 0;    // of all channels, 0..255
  double fractionOver16 = 0;  // of pixels
  int pixels = 0;
};

using Pick = std::function<bool(int x, int y)>;

bool everywhere(int, int) {
  return true;
}

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
  Mesh original = *finished.original.mesh;
  original.positions = mapPoints(original.positions, [&](const Point& p) { return p + away; });
  finished = *finishLevel(level, std::make_shared<const Mesh>(std::move(original)), 0);
  const Bitmap view = pictureOf(tracerInput(finished, size, size));
  const Difference all =
      differenceOf(view, tracedPicture(finished, size, size), [](int, int) { return true; });
  EXPECT_LE(all.meanAbsolute, 0.6);
  EXPECT_LE(all.fractionOver16, 0.01);
}

// With other rules of tracing the rules are the same, too.
TEST_P(Parity, HoldsForEveryDepthAndWithoutShadows) {
  constexpr int size = 160;
  LevelResult finished = finishedLevel(GetParam());
  Bitmap first;
  for (const auto& [depth, shadows] : {std::pair{0, true}, {8, true}, {3, false}}) {
    finished.level.tracing.maxDepth = depth;
    finished.level.tracing.shadows = shadows;
    const Bitmap view = pictureOf(tracerInput(finished, size, size));
    EXPECT_FALSE(view == first) << "they differ from each other";
    first = view;
    const Difference all = differenceOf(view, tracedPicture(finished, size, size), everywhere);
    EXPECT_LE(all.meanAbsolute, 0.1) << depth;
    EXPECT_LE(all.fractionOver16, 0.001) << depth;
  }
}

// Parallel rays: the tracer's camera has none, so they are traced by hand. It softens the ground's grid by an angle
// and the view by a length, so the ground is away, and then there but outside of the mirror.
TEST_P(Parity, HoldsForParallelRays) {
  constexpr int width = 200, height = 150;
  LevelResult finished = finishedLevel(GetParam());
  const ViewSettings& start = finished.level.view;
  for (const bool ground : {false, true}) {
    finished.level.ground.visible = ground;
    ViewportInput input = tracerInput(finished, width, height);
    input.pose = {start.eye, start.target, {0, 0, 1}, start.fovDegrees, true};
    const ViewProjection projection(input.pose, width, height);
    const double pixel = projection.unitsPerPixel(start.target);
    const RenderScene scene = buildScene(makeReflectionScene(finished.level, finished.sculpture));
    Image traced(width, height);
    std::vector<bool> mirror;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const Ray ray = projection.rayThrough({x + 0.5, y + 0.5});
        const auto hit = findHit(scene, ray);
        TraceOptions options{finished.level.tracing.maxDepth, finished.level.tracing.shadows, 0};
        if (hit) options.pixelAngle = pixel / hit->t;
        traced.pixels[mirror.size()] = traceColor(scene, ray, options);
        mirror.push_back(hit && hit->object.kind == ObjectKind::optic);
      }
    }
    const Difference all = differenceOf(pictureOf(input), toBitmap(traced), [&](int x, int y) {
      return !ground || !mirror[static_cast<std::size_t>(y * width + x)];
    });
    EXPECT_GT(all.pixels, 10'000);
    EXPECT_LE(all.meanAbsolute, 0.1) << ground;
    EXPECT_LE(all.fractionOver16, 0.001) << ground;
  }
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

// A canvas reflects nothing and is in no picture, but the sculpture is.
TEST_F(CanvasParity, ShowsWhatTheTracerShows) {
  constexpr int size = 240;
  const LevelResult& finished = finishedLevel("0-perspective");
  ASSERT_FALSE(isVisible(finished.level.optic));
  const Bitmap traced = tracedPicture(finished, size, size);
  const Bitmap view = pictureOf(tracerInput(finished, size, size));
  EXPECT_GT(count(view, isSculptureColor), 200);
  const Difference all = differenceOf(view, traced, everywhere);
  EXPECT_LE(all.meanAbsolute, 0.1);
  EXPECT_LE(all.fractionOver16, 0.001);
}

// From within a cylinder, where rays are reflected again and again.
TEST_F(CanvasParity, InsideOfACylinderRaysAreReflectedAgainAndAgain) {
  constexpr int size = 160;
  LevelResult finished = finishedLevel("2-cylinder");
  Level& level = finished.level;
  const CylinderMirror& tube = shapeAs<CylinderMirror>(level.optic.shape());
  const Vector axis = tube.top - tube.bottom;
  const Direction x = perpendicular(glm::normalize(axis)), y = glm::cross(glm::normalize(axis), x);
  level.camera.eye = tube.bottom + 0.5 * axis + 0.5 * tube.radius * x;
  level.camera.target = level.camera.eye + tube.radius * y;
  level.camera.fovDegrees = 90;
  std::vector<Bitmap> pictures;
  for (const int depth : {0, 1, 2, 8}) {
    level.tracing.maxDepth = depth;
    pictures.push_back(pictureOf(tracerInput(finished, size, size)));
    const Difference all = differenceOf(pictures.back(), tracedPicture(finished, size, size), everywhere);
    EXPECT_LE(all.meanAbsolute, 0.5) << depth;
    EXPECT_LE(all.fractionOver16, 0.01) << depth;
  }
  EXPECT_FALSE(pictures[2] == pictures[3]) << "more than two reflections are seen";
}

// A ball of which a slice and a corner are kept, so that rays pass through what is cut away and meet its inside.
TEST_F(CanvasParity, ACutMirrorShowsWhatTheTracerShows) {
  constexpr int size = 240;
  Level level = finishedLevel("3-sphere").level;
  const SphereMirror ball = shapeAs<SphereMirror>(level.optic.shape());
  level.optic.shape().clipBy({{ball.centre + Vector(0, 0, 0.4 * ball.radius), {0.1, 0, -1}},
                              {ball.centre - Vector(0.5 * ball.radius, 0, 0), {3, 0.5, 0}}});
  const LevelResult finished = *finishLevel(level, finishedLevel("3-sphere").original.mesh, 0);
  const Bitmap view = pictureOf(tracerInput(finished, size, size));
  const Difference all = differenceOf(view, tracedPicture(finished, size, size), everywhere);
  EXPECT_LE(all.meanAbsolute, 0.15);
  EXPECT_LE(all.fractionOver16, 0.002);
  const Difference whole =
      differenceOf(view, tracedPicture(finishedLevel("3-sphere"), size, size), everywhere);
  EXPECT_GT(whole.fractionOver16, 0.02) << "something is cut away";
}

// The triangles of a ball, cut off too, are nearly the ball itself.
TEST_F(CanvasParity, AMirrorOfTrianglesShowsWhatTheExactOneDoes) {
  constexpr int size = 240;
  Level level = finishedLevel("3-sphere").level;
  const SphereMirror ball = shapeAs<SphereMirror>(level.optic.shape());
  SmoothMesh surface;
  surface.mesh = tessellate(ball, 256).mesh;
  surface.normals =
      mapPoints(surface.mesh.positions, [&](const Point& p) { return (p - ball.centre) / ball.radius; });
  for (const bool cut : {false, true}) {
    level.optic.shape() = ball;
    if (cut) level.optic.shape().clipBy({{ball.centre, {0.3, 0, -1}}});
    const LevelResult exact = *finishLevel(level, finishedLevel("3-sphere").original.mesh, 0);
    const std::vector<HalfSpace> clip = level.optic.shape().clip();
    level.optic.shape() = meshMirror(surface);
    level.optic.shape().clipBy(clip);
    LevelResult finished = exact;
    finished.level = level;
    const Bitmap view = pictureOf(tracerInput(finished, size, size));
    const Difference all = differenceOf(view, tracedPicture(exact, size, size), everywhere);
    EXPECT_LE(all.meanAbsolute, 0.5) << cut;
    EXPECT_LE(all.fractionOver16, 0.01) << cut;
    const Difference own = differenceOf(view, tracedPicture(finished, size, size), everywhere);
    EXPECT_LE(own.meanAbsolute, 0.15) << cut;
    EXPECT_LE(own.fractionOver16, 0.002) << cut;
  }
}

// One checked level of each kind (tests/data/optics). Quadrics have formulas on both sides; others are triangles in the
// view, and exact in the tracer.
struct OpticCase {
  const char* level;
  bool exact;
};
class OpticParity : public GlTest, public testing::WithParamInterface<OpticCase> {};

TEST_P(OpticParity, ShowsWhatTheTracerShows) {
  constexpr int size = 240;
  const LevelResult& finished = finishedLevel(std::string("../optics/") + GetParam().level);
  const Bitmap view = pictureOf(tracerInput(finished, size, size));
  const Bitmap traced = tracedPicture(finished, size, size);
  const Difference mirror = differenceOf(view, traced, seesMirror(finished, size, size));
  EXPECT_GT(mirror.pixels, 2500);
  for (const Difference& difference : {mirror, differenceOf(view, traced, everywhere)}) {
    EXPECT_LE(difference.meanAbsolute, GetParam().exact ? 0.5 : 2);
    EXPECT_LE(difference.fractionOver16, GetParam().exact ? 0.01 : 0.03);
  }
}

INSTANTIATE_TEST_SUITE_P(Optics, OpticParity,
                         testing::Values(OpticCase{"ellipsoid-box", true}, OpticCase{"paraboloid-box", true},
                                         OpticCase{"concave-box", true}, OpticCase{"vase-box", false},
                                         OpticCase{"wavy-box", false}, OpticCase{"patch-pawn", false}));

INSTANTIATE_TEST_SUITE_P(Levels, Parity,
                         testing::Values("1-plane", "2-cylinder", "3-sphere", "cone", "mesh"));

}  // namespace
}  // namespace anamorph::test
