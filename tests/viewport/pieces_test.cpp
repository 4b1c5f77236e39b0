// The 3D view drawn piece by piece: the way there is another one, the picture is the same.

#include "geometry/shapes.h"
#include "viewport/viewport_fixture.h"

namespace anamorph::test {
namespace {

using PiecesOfAView = GlTest;

constexpr double noTime = 0;

/// One piece a call until it is complete; returns how many calls that took.
int drawInPieces(Viewport& viewport, const ViewportInput& input, double scale, int samples) {
  int calls = 0;
  do {
    EXPECT_TRUE(viewport.draw(input, scale, 1, samples, noTime));
  } while (++calls < 100'000 && !viewport.complete());
  return calls;
}

/// With everything in it that is drawn in pieces: ghost, wires, dots, lines, an outline.
ViewportInput richInput(const std::string& level, Part selected) {
  ViewportInput input = startInput(finishedLevel(level), 300, 70);
  input.display.wireframe = true;
  input.display.statusColors = true;
  input.selection.part = selected;
  std::vector<Line> lines;
  for (int i = 0; i < 100; ++i) lines.push_back({{0.1 * i - 5, -9, 9}, {0, -3, 5}});
  input.lines = std::make_shared<const std::vector<Line>>(std::move(lines));
  const auto sculpture = std::make_shared<Sculpture>(*input.sculpture.sculpture);
  for (std::size_t i = 0; i < sculpture->status.size(); i += 3) sculpture->status[i] = PathStatus::grazing;
  input.sculpture.sculpture = sculpture;
  return input;
}

/// A mesh with more triangles than the picture has pixels, which is traced in software, and many texels.
ViewportInput largeInput() {
  ViewportInput input = startInput(finishedLevel("1-plane"), 120, 90);
  Mesh knot = makeTorusKnot(2, 3, 0.25, 1000, 40);
  knot.positions = mapPoints(knot.positions, [](const Point& p) { return Point(0, 5, 2) + p; });
  input.original = prepareMesh(std::make_shared<const Mesh>(std::move(knot)));
  input.display.originalLook = OriginalLook::solid;
  input.selection.part = Part::original;
  return input;
}

TEST_F(PiecesOfAView, MakeTheSamePicture) {
  std::vector<ViewportInput> inputs{largeInput()};
  for (const Part part : {Part::none, Part::sculpture, Part::mirror, Part::original, Part::light})
    inputs.push_back(richInput("2-cylinder", part));
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    SCOPED_TRACE(i);
    for (const int samples : {1, 3}) {
      Viewport viewport;
      const int calls = drawInPieces(viewport, inputs[i], 1, samples);
      EXPECT_GT(calls, 20 * samples);
      EXPECT_EQ(viewport.readBack(), pictureOf(inputs[i], samples));
    }
  }
}

TEST_F(PiecesOfAView, ShowOnlyWholePictures) {
  const ViewportInput input = richInput("2-cylinder", Part::none);
  const Bitmap coarse = [&] {
    Viewport viewport;
    return pictureOf(viewport, input, 1, 0.25);
  }();
  std::vector<Bitmap> whole;
  for (const int samples : {1, 2}) whole.push_back(pictureOf(input, samples));
  Viewport viewport;
  drawInPieces(viewport, input, 0.25, 1);
  std::size_t seen = 0;  // of: coarse, one sample, two
  while (!viewport.complete() || seen < 2) {
    viewport.draw(input, 1, 1, 2, noTime);
    const Bitmap now = viewport.readBack();
    if (seen < 2 && now == whole[seen]) ++seen;
    ASSERT_EQ(now, seen == 0 ? coarse : whole[seen - 1]);
  }
}

TEST_F(PiecesOfAView, AnotherInputStartsAnew) {
  const ViewportInput first = richInput("2-cylinder", Part::none);
  ViewportInput other = first;
  other.pose.eye.z += 3;
  Viewport viewport;
  drawInPieces(viewport, first, 0.25, 1);
  for (int i = 0; i < 30; ++i) viewport.draw(first, 1, 1, 4, noTime);
  EXPECT_TRUE(viewport.current());
  viewport.draw(other, 0.25, 1, 1, noTime);
  EXPECT_FALSE(viewport.current());
  EXPECT_FALSE(viewport.complete());
  drawInPieces(viewport, other, 0.25, 1);
  EXPECT_TRUE(viewport.current());
  Viewport fresh;
  EXPECT_EQ(viewport.readBack(), pictureOf(fresh, other, 1, 0.25));
}

// Otherwise a drag whose pictures take more than a frame would show none before it ends.
TEST_F(PiecesOfAView, AMovingInputIsSeenOnItsWay) {
  Viewport viewport;
  ViewportInput input = startInput(finishedLevel("2-cylinder"), 60, 40);
  drawInPieces(viewport, input, 0.5, 1);
  int pictures = 0;
  Bitmap last = viewport.readBack();
  for (int i = 0; i < 300; ++i) {
    input.pose.eye.z += 0.05;
    viewport.draw(input, 0.5, 1, 1, noTime);
    EXPECT_FALSE(viewport.complete());
    const Bitmap now = viewport.readBack();
    pictures += !(now == last);
    last = now;
  }
  EXPECT_GT(pictures, 2);
  drawInPieces(viewport, input, 0.5, 1);
  Viewport fresh;
  EXPECT_EQ(viewport.readBack(), pictureOf(fresh, input, 1, 0.5));
}

TEST_F(PiecesOfAView, AnUploadThatWasBrokenOffIsMadeUpFor) {
  const ViewportInput small = startInput(finishedLevel("1-plane"), 120, 90), large = largeInput();
  const Bitmap expected = pictureOf(large);
  Viewport viewport;
  pictureOf(viewport, small);
  for (int calls = 0; calls < 20; ++calls) {
    SCOPED_TRACE(calls);
    for (int i = 0; i < calls; ++i) viewport.draw(large, 1, 1, 1, noTime);
    viewport.draw(small, 1, 1, 1);
    ASSERT_EQ(pictureOf(viewport, large), expected);
    pictureOf(viewport, small);
  }
}

TEST_F(PiecesOfAView, TellWhatASampleCosts) {
  Viewport viewport;
  const ViewportInput input = startInput(finishedLevel("1-plane"), 60, 40);
  pictureOf(viewport, input);
  EXPECT_FALSE(viewport.takeCost()) << "nobody waited for it";
  drawInPieces(viewport, input, 0.5, 1);
  const auto cost = viewport.takeCost();
  ASSERT_TRUE(cost);
  EXPECT_EQ(cost->scale, 0.5);
  EXPECT_GT(cost->milliseconds, 0);
  EXPECT_FALSE(viewport.takeCost());
}

}  // namespace
}  // namespace anamorph::test
