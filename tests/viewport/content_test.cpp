// What is in the picture: lines, outlines, the pixel grid, the original in its three looks, vertices that are
// missing.

#include <cmath>

#include "geometry/shapes.h"
#include "viewport/viewport_fixture.h"

namespace anamorph::test {
namespace {

using Content = GlTest;

const LevelResult& cylinder() {
  return finishedLevel("2-cylinder");
}

ViewportInput bareInput(int width = 160, int height = 120) {
  ViewportInput input = startInput(cylinder(), width, height);
  input.display.originalLook = OriginalLook::hidden;
  input.display.rtCamera = false;
  input.display.lightMarkers = false;
  return input;
}

ViewportInput withLines(ViewportInput input, std::vector<Line> lines) {
  input.lines = std::make_shared<const std::vector<Line>>(std::move(lines));
  return input;
}

/// Across the picture, in front of everything.
Line acrossTheView(const ViewportInput& input, double from = 0.2, double to = 0.8) {
  const ViewProjection view(input.pose, input.width, input.height);
  const auto at = [&](double x) { return view.rayThrough({x * input.width, 0.5 * input.height}).at(2); };
  Line line{at(from), at(to)};
  line.width = 6;
  return line;
}

TEST_F(Content, LinesHaveTheirColor) {
  ViewportInput input = bareInput();
  Line line = acrossTheView(input);
  line.color = Color(0.2, 0.6, 1);
  for (const int samples : {1, 8}) {
    const Bitmap picture = pictureOf(withLines(input, {line}), samples);
    const Rgba c = at(picture, 80, 60);
    EXPECT_NEAR(c.r, 51, 2);
    EXPECT_NEAR(c.g, 153, 2);
    EXPECT_NEAR(c.b, 255, 2);
  }
  EXPECT_EQ(at(pictureOf(withLines(input, {line})), 80, 40), at(pictureOf(input), 80, 40)) << "beside it";
}

TEST_F(Content, LinesAreHiddenFaintlyUnlessInFront) {
  ViewportInput input = bareInput();
  Line line = acrossTheView(input, 0.5, 0.55);
  line.color = Color(0, 1, 0);
  const Vector away = 60.0 * glm::normalize(input.pose.target - input.pose.eye);
  line.from += away;
  line.to += away;  // below the ground
  const ViewProjection view(input.pose, 160, 120);
  const Pixel middle = *view.pixelOf(0.5 * (line.from + line.to));
  line.width = 30;
  const int x = static_cast<int>(middle.x), y = static_cast<int>(middle.y);
  const Rgba bare = at(pictureOf(input), x, y), faint = at(pictureOf(withLines(input, {line})), x, y);
  EXPECT_NEAR(faint.g, bare.g + 0.18 * (255 - bare.g), 3);
  line.inFront = true;
  EXPECT_EQ(at(pictureOf(withLines(input, {line})), x, y), (Rgba{0, 255, 0, 255}));
}

TEST_F(Content, DashesAndDotsHaveGaps) {
  ViewportInput input = bareInput();
  Line line = acrossTheView(input);
  line.color = Color(1, 0, 0);
  line.width = 3;
  const auto red = [](const Rgba& c) { return c.r > 250 && c.g < 6 && c.b < 6; };
  const int solid = count(pictureOf(withLines(input, {line})), red);
  line.style = LineStyle::dashed;
  const int dashed = count(pictureOf(withLines(input, {line})), red);
  line.style = LineStyle::dotted;
  const int dotted = count(pictureOf(withLines(input, {line})), red);
  EXPECT_GT(solid, 180);
  EXPECT_LT(dashed, 0.75 * solid);
  EXPECT_GT(dashed, 0.3 * solid);
  EXPECT_LT(dotted, 0.6 * solid);
  EXPECT_GT(dotted, 0.05 * solid);
}

TEST_F(Content, ArrowHeadsAreInTheMiddle) {
  ViewportInput input = bareInput();
  Line line = acrossTheView(input);
  line.color = Color(1, 0, 0);
  line.width = 4;
  const auto red = [](const Rgba& c) { return c.r > 250 && c.g < 6 && c.b < 6; };
  const Bitmap plain = pictureOf(withLines(input, {line}));
  line.arrow = true;
  const Bitmap arrow = pictureOf(withLines(input, {line}));
  EXPECT_GT(count(arrow, red), count(plain, red) + 30);
  EXPECT_TRUE(red(at(arrow, 74, 64))) << "the base, to the left of the middle";
  EXPECT_FALSE(red(at(arrow, 87, 64))) << "the tip";
}

TEST_F(Content, LinesThroughTheEyeAreCut) {
  ViewportInput input = bareInput();
  const ViewProjection view(input.pose, 160, 120);
  Line line{view.rayThrough({80, 60}).at(5),
            input.pose.eye - 5.0 * view.frame().forward + view.frame().right};
  line.width = 4;
  line.color = Color(1, 0, 0);
  const Bitmap picture = pictureOf(withLines(input, {line}));
  const auto red = [](const Rgba& c) { return c.r > 250 && c.g < 6 && c.b < 6; };
  EXPECT_GT(count(picture, red), 100);
  EXPECT_TRUE(red(at(picture, 158, 60)) || red(at(picture, 158, 61)) || red(at(picture, 158, 59)));
  EXPECT_FALSE(red(at(picture, 40, 60)));
}

TEST_F(Content, WidthsFollowTheScaleOfThePicture) {
  ViewportInput input = bareInput(200, 150);
  Line line = acrossTheView(input);
  line.color = Color(1, 0, 0);
  line.width = 8;
  const auto red = [](const Rgba& c) { return c.r > 250 && c.g < 6 && c.b < 6; };
  Viewport viewport;
  const int full = count(pictureOf(viewport, withLines(input, {line})), red);
  const int half = count(pictureOf(viewport, withLines(input, {line}), 1, 0.5), red);
  EXPECT_NEAR(half, full / 4, full / 16);
  input.lineScale = 2;
  EXPECT_NEAR(count(pictureOf(viewport, withLines(input, {line})), red), 2 * full, full / 4);
}

TEST_F(Content, SelectionIsOutlined) {
  const auto orange = [](const Rgba& c) { return c.r > 240 && std::abs(c.g - 89) < 12 && c.b < 12; };
  ViewportInput input = startInput(cylinder(), 320, 240);
  input.display.rtCamera = true;
  const int none = count(pictureOf(input), orange);
  EXPECT_EQ(none, 0);
  for (const Part part : {Part::original, Part::sculpture, Part::mirror, Part::eye, Part::light}) {
    input.selection = {part, 0};
    input.pose.eye = input.level.view.eye;
    if (part == Part::light) input.pose.target = input.level.lights[0].position;
    EXPECT_GT(count(pictureOf(input), orange), part == Part::light ? 10 : 40) << static_cast<int>(part);
  }
  input.selection = {Part::light, 77};
  EXPECT_EQ(count(pictureOf(input), orange), 0);
  input.selection = {Part::original, 0};
  input.display.originalLook = OriginalLook::hidden;
  EXPECT_EQ(count(pictureOf(input), orange), 0);
}

// A mirror of triangles, too, and of a cut one only what is kept.
TEST_F(Content, SelectedMirrorsAreOutlinedAsTheyAreSeen) {
  const auto orange = [](const Rgba& c) { return c.r > 240 && std::abs(c.g - 89) < 12 && c.b < 12; };
  ViewportInput input = startInput(finishedLevel("mesh"), 320, 240);
  input.selection = {Part::mirror, 0};
  EXPECT_GT(count(pictureOf(input), orange), 200);
  input = startInput(finishedLevel("3-sphere"), 320, 240);
  input.selection = {Part::mirror, 0};
  const int whole = count(pictureOf(input), orange);
  Shape& ball = input.level.optic.shape();
  ball.clipBy({{middleOf(ball) + Vector(0, 0, 0.3 * boxOf(ball).size().z), {0, 0, 1}}});
  const int cap = count(pictureOf(input), orange);
  EXPECT_GT(cap, 40);
  EXPECT_LT(cap, 0.8 * whole);
}

TEST_F(Content, OriginalIsSolidGhostOrHidden) {
  ViewportInput input = bareInput();
  input.pose = {{3, 14, 4}, {0, 3.75, 2}, {0, 0, 1}, 40, false};  // from behind the mirror
  const auto blue = [](const Rgba& c) { return c.b > c.r + 35; };
  const int hidden = count(pictureOf(input), blue);
  input.display.originalLook = OriginalLook::solid;
  const int solid = count(pictureOf(input), blue);
  input.display.originalLook = OriginalLook::ghost;
  const Bitmap ghost = pictureOf(input);
  EXPECT_GT(solid, hidden + 1000);
  EXPECT_GT(compare(ghost, pictureOf(bareInput()), 10).fractionOver, 0.05);
  EXPECT_NE(at(ghost, 80, 60), at(pictureOf(bareInput()), 80, 60));
}

TEST_F(Content, GhostShinesThroughTheMirror) {
  ViewportInput input = bareInput();
  const Bitmap without = pictureOf(input);
  input.display.originalLook = OriginalLook::ghost;
  const BitmapDifference difference = compare(pictureOf(input), without, 4);
  EXPECT_GT(difference.fractionOver, 0.005);
}

// Where both are in the same place, or one is seen through the other's reflection, there is one colour of the two.
TEST_F(Content, GhostAndSculptureDoNotMix) {
  for (const char* name : {"0-perspective", "1-plane"}) {
    SCOPED_TRACE(name);
    const LevelResult& finished = finishedLevel(name);
    Level level = finished.level;
    level.sculpture.depthScale = 1;
    ViewportInput input = startInput(*finishLevel(level, finished.original.mesh, 0), 320, 240);
    input.display.rtCamera = false;
    input.display.originalLook = OriginalLook::hidden;
    const Bitmap without = pictureOf(input);
    input.display.originalLook = OriginalLook::ghost;
    const Bitmap with = pictureOf(input);
    int orange = 0, mixed = 0;
    for (int y = 0; y < 240; ++y) {
      for (int x = 0; x < 320; ++x) {
        const Rgba c = at(without, x, y), now = at(with, x, y);
        if (!(c.r > c.b + 60)) continue;
        ++orange;
        mixed += !(now.r > now.b + 60);
      }
    }
    EXPECT_GT(orange, 400);
    EXPECT_LT(mixed, 0.02 * orange) << "borders only";
  }
}

TEST_F(Content, OriginalIsInTheMirrorOnRequest) {
  ViewportInput input = bareInput();
  input.pose = {{0, -14, 3}, {0, 0, 3}, {0, 0, 1}, 40, false};
  // The original stands before the mirror this time.
  input.original = prepareMesh(std::make_shared<const Mesh>([&] {
    Mesh mesh = makeSphere(1, 32);
    mesh.positions = mapPoints(mesh.positions, [](const Point& p) { return p + Point(5, -6, 3); });
    return mesh;
  }()));
  input.display.originalLook = OriginalLook::ghost;
  const Bitmap without = pictureOf(input);
  input.display.originalInMirror = true;
  EXPECT_GT(compare(pictureOf(input), without, 20).fractionOver, 0.001);
}

TEST_F(Content, ScreenShowsItsImage) {
  ViewportInput input = bareInput();
  input.display.rtCamera = true;
  input.display.screenOpacity = 1;
  const Camera& camera = input.level.camera;
  const Projection projection(camera, 8, 8);
  const Direction forward = projection.frame().forward;
  const Point middle = camera.eye + input.level.grid.distance * forward;
  input.pose = {middle + 0.6 * forward, middle, {0, 0, 1}, 60, false};  // seen from the mirror
  auto image = std::make_shared<Image>(2, 2);
  image->at(0, 0) = {1, 0, 0};  // upper left as the RT camera sees it, so upper right from here
  image->at(1, 0) = {0, 0.5, 0};
  image->at(0, 1) = {0, 0, 0.5};
  image->at(1, 1) = {0.2, 0.2, 0.2};
  input.screen = image;
  const Bitmap picture = pictureOf(input);
  const auto shown = [](float linear) { return std::lround(255 * toDisplay(linear)); };
  EXPECT_EQ(at(picture, 95, 45), (Rgba{static_cast<int>(shown(1)), 0, 0, 255}));
  EXPECT_NEAR(at(picture, 65, 45).g, shown(0.5), 1);
  EXPECT_NEAR(at(picture, 95, 75).b, shown(0.5), 1);
  EXPECT_NEAR(at(picture, 65, 75).r, shown(0.2f), 1);
  input.display.rtCamera = false;
  EXPECT_NE(at(pictureOf(input), 95, 45).g, 0) << "hidden with the RT camera";
}

TEST_F(Content, RtCameraIsNotSeenFromWithin) {
  ViewportInput input = tracerInput(cylinder(), 120, 120);
  const Bitmap without = pictureOf(input);
  input.display.rtCamera = true;
  input.screen = std::make_shared<const Image>(4, 4);
  EXPECT_EQ(pictureOf(input), without);
}

TEST_F(Content, TransparentBackground) {
  ViewportInput input = bareInput();
  input.transparent = true;
  const Bitmap picture = pictureOf(input, 4);
  EXPECT_EQ(at(picture, 2, 2).a, 0);
  EXPECT_EQ(at(picture, 2, 117).a, 0);
  EXPECT_GT(count(picture, [](const Rgba& c) { return c.a == 255; }), 500);
  EXPECT_GT(count(picture, [](const Rgba& c) { return c.a > 0 && c.a < 255; }), 20) << "smooth edges";
}

TEST_F(Content, BackgroundOfTheDisplayWins) {
  ViewportInput input = bareInput();
  input.display.background = Background{Color(1, 0, 0), Color(1, 0, 0)};
  const Rgba sky = at(pictureOf(input), 3, 3);
  EXPECT_GT(sky.r, 200);
  EXPECT_EQ(sky.g, 0);
}

// Unmapped corners take their triangles out, in the direct view as in the mirror.
TEST_F(Content, UnmappedVerticesDisappear) {
  ViewportInput input = bareInput();
  const Bitmap whole = pictureOf(input);
  EXPECT_GT(count(whole, isSculptureColor), 200);
  ViewportInput none = input;
  none.display.sculpture = false;
  auto sculpture = std::make_shared<Sculpture>(*input.sculpture.sculpture);
  std::fill(sculpture->status.begin(), sculpture->status.end(), PathStatus::missesMirror);
  ViewportInput masked = input;
  masked.sculpture.sculpture = sculpture;
  EXPECT_EQ(pictureOf(masked), pictureOf(none));

  auto half = std::make_shared<Sculpture>(*input.sculpture.sculpture);
  for (std::size_t i = 0; i < half->status.size(); ++i) {
    if (half->mesh.positions.x[i] > 0) half->status[i] = PathStatus::grazing;
  }
  masked.sculpture.sculpture = half;
  const int seen = count(pictureOf(masked), isSculptureColor);
  EXPECT_GT(seen, 0.2 * count(whole, isSculptureColor));
  EXPECT_LT(seen, 0.8 * count(whole, isSculptureColor));
  masked.display.statusColors = true;
  EXPECT_GT(count(pictureOf(masked), [](const Rgba& c) { return c.r > 220 && c.g > 200 && c.b < 110; }), 20)
      << "yellow dots of grazing rays";
}

TEST_F(Content, RefittedMeshIsDrawnAsAFreshOne) {
  ViewportInput input = bareInput();
  ViewportInput moved = input;
  moved.level.sculpture.depthScale = 0.4;
  auto sculpture = std::make_shared<Sculpture>(*input.sculpture.sculpture);
  remapSculpture(makeVertexMap(moved.level), *sculpture, 1);
  auto bvh = std::make_shared<Bvh>(*input.sculpture.prepared.bvh);
  bvh->refit(sculpture->mesh.positions);
  PreparedMesh& prepared = moved.sculpture.prepared;
  moved.sculpture.sculpture = sculpture;
  prepared.mesh = std::shared_ptr<const Mesh>(sculpture, &sculpture->mesh);
  prepared.bvh = bvh;
  prepared.normals = std::make_shared<const std::vector<glm::vec3>>(
      computeNormals(sculpture->mesh.positions, sculpture->mesh.triangles, *prepared.normalGroups));
  Viewport viewport;
  const Bitmap before = pictureOf(viewport, input);
  const Bitmap after = pictureOf(viewport, moved);
  EXPECT_NE(before, after);
  EXPECT_EQ(after, pictureOf(moved));
  EXPECT_EQ(pictureOf(viewport, input), before);
}

TEST_F(Content, AnotherMeshReplacesTheOld) {
  Viewport viewport;
  const ViewportInput small = bareInput();
  const Bitmap before = pictureOf(viewport, small);
  ViewportInput large = small;
  large.level.sculpture.tolerancePixels = 0;
  Sculpture sculpture;
  sculpture.mesh = makeTorusKnot(2, 3, 0.3, 400, 24);
  sculpture.mesh.positions =
      mapPoints(sculpture.mesh.positions, [](const Point& p) { return 2.0 * p + Point(0, -6, 4); });
  sculpture.original = sculpture.mesh.positions;
  sculpture.status.assign(sculpture.mesh.positions.size(), PathStatus::mapped);
  large.sculpture = prepareSculpture(std::move(sculpture));
  const Bitmap after = pictureOf(viewport, large);
  EXPECT_EQ(after, pictureOf(large));
  EXPECT_EQ(pictureOf(viewport, small), before);
  ViewportInput none = small;
  none.sculpture = {};
  none.original = {};
  EXPECT_EQ(count(pictureOf(viewport, none), isSculptureColor), 0);
}

TEST_F(Content, WiresAreDark) {
  ViewportInput input = bareInput();
  input.pose = {{-3, -8, 5}, {0, -4, 4}, {0, 0, 1}, 20, false};
  const Bitmap plain = pictureOf(input);
  input.display.wireframe = true;
  const Bitmap wires = pictureOf(input);
  const auto brightness = [](const Bitmap& b) {
    double sum = 0;
    for (const std::uint8_t byte : b.bytes) sum += byte;
    return sum;
  };
  EXPECT_LT(brightness(wires), brightness(plain));
  EXPECT_GT(compare(wires, plain, 10).fractionOver, 0.02);
}

}  // namespace
}  // namespace anamorph::test
