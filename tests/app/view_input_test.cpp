#include "app/view_input.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "edit/advance.h"
#include "optics/patch.h"
#include "panels/style.h"
#include "viewport/ray_lines.h"

namespace anamorph {
namespace {

// A finished level, as Gui::frame would hand it over.
class ViewInput : public testing::Test {
 protected:
  void SetUp() override {
    openLevel(editor, std::string(ANAMORPH_LEVELS) + "/2-cylinder.json");
    finish();
  }
  // All there, ray trees included where they are wanted.
  void finish() {
    editor.updater.finish(editor.session, {64, false});
    advance(editor, 0);
  }
  ViewportInput make() { return maker.make(editor, ui, ShownRays(editor), false); }
  CausticStage caustic;
  std::vector<Line> lines() { return makeLines(editor, ui, ShownRays(editor), caustic); }
  // Without RT camera and construction, so that rays are all that is left.
  std::size_t rayCount() {
    editor.display.rtCamera = false;
    return lines().size();
  }

  Editor editor{{}, 2};
  UiState ui;
  ViewInputMaker maker;
};

TEST_F(ViewInput, IsEqualWhileNothingChanges) {
  const ViewportInput first = make();
  for (int i = 0; i < 3; ++i) {
    advance(editor, 0.1);
    const ViewportInput again = make();
    EXPECT_EQ(first, again);
    EXPECT_EQ(first.lines.get(), again.lines.get()) << "the same lines keep their pointer: no upload";
  }
}

TEST_F(ViewInput, TheCanvasIsHighlightedWhileItsControlPointIsSelected) {
  Level level = editor.session.level();
  level.optic = {OpticKind::canvas, PatchMirror{}};
  editor.session.edit(level);
  finish();
  const auto linesWith = [&](const Selection& selection) {
    editor.selection = selection;
    return lines();
  };
  const std::vector<Line> selected = linesWith({Part::mirror});
  EXPECT_EQ(linesWith({Part::controlPoint, 14}), selected);
  EXPECT_NE(linesWith({}), selected);
}

TEST_F(ViewInput, ChangesWithTheView) {
  const ViewportInput first = make();
  editor.pose.fovDegrees += 1;
  EXPECT_FALSE(first == make());
}

TEST_F(ViewInput, ChangesWithWhatIsLookedAt) {
  const auto changes = [&](auto&& change) {
    const ViewportInput before = make();
    change();
    const ViewportInput after = make();
    return !(before == after);
  };
  EXPECT_TRUE(changes([&] { editor.selection = {Part::mirror}; }));
  EXPECT_TRUE(changes([&] { editor.display.wireframe = true; }));
  EXPECT_TRUE(changes([&] { editor.rays.vertexCount = 3; }));
  EXPECT_TRUE(changes([&] { ui.scale = 2; }));
  EXPECT_TRUE(changes([&] { ui.theme = Theme::projector; }));
  EXPECT_TRUE(changes([&] { editor.viewWidth += 1; }));
  EXPECT_TRUE(changes([&] { ui.hoveredCell = GridCell{2, 2}; }));
  EXPECT_FALSE(changes([&] { ui.mouse.hoveredHandle = GizmoHandle::x; }))
      << "is drawn over the view, not in it";
  EXPECT_FALSE(changes([&] { editor.status.say("hello"); }));
}

TEST_F(ViewInput, HasTheSkyOfItsTheme) {
  EXPECT_EQ(make().display.background, skyOf(Theme::dark));
  ui.theme = Theme::projector;
  EXPECT_EQ(make().display.background, skyOf(Theme::projector));
  editor.display.background = Background{};
  EXPECT_EQ(make().display.background, Background{});
}

TEST_F(ViewInput, LookingThroughHidesWhatWouldBeInTheWay) {
  ASSERT_EQ(editor.display.originalLook, OriginalLook::ghost);
  toggleLookThrough(editor);
  EXPECT_TRUE(make().display.rtCamera) << "still flying";
  advance(editor, 1);
  ASSERT_FALSE(editor.flight);
  EXPECT_FALSE(make().display.rtCamera);
  EXPECT_EQ(make().display.originalLook, OriginalLook::hidden);
  editor.display.originalLook = OriginalLook::solid;
  EXPECT_EQ(make().display.originalLook, OriginalLook::solid);
  toggleLookThrough(editor);
  advance(editor, 1);
  EXPECT_TRUE(make().display.rtCamera);
}

TEST_F(ViewInput, ShowsVertexRaysAtFirst) {
  const std::size_t rays = rayCount();
  EXPECT_GT(rays, 0u);
  editor.rays.vertexCount *= 2;
  EXPECT_GT(rayCount(), rays);
  editor.rays.show = false;
  EXPECT_EQ(rayCount(), 0u);
}

TEST_F(ViewInput, APickedPointHasItsConstructionAlone) {
  editor.point = pickedVertex(*editor.updater.result().original.mesh, 5);
  ASSERT_TRUE(editor.point);
  const std::size_t construction = rayCount();
  EXPECT_GT(construction, 0u);
  editor.rays.vertexCount *= 2;
  EXPECT_EQ(rayCount(), construction) << "no other vertex rays";
  editor.rays.show = false;
  EXPECT_EQ(rayCount(), construction) << "it was asked for by a click";
}

TEST_F(ViewInput, PixelRaysOfAllCellsOrOfOne) {
  editor.rays.source = RaySource::pixels;
  EXPECT_EQ(rayCount(), 0u) << "not traced yet";
  advance(editor, 0);
  const std::size_t all = rayCount();
  EXPECT_GT(all, 0u);
  editor.cell = GridCell{4, 4};
  advance(editor, 0);
  const std::size_t one = rayCount();
  EXPECT_GT(one, 0u);
  EXPECT_LT(one, all);
  editor.rays.show = false;
  EXPECT_EQ(rayCount(), 0u);
}

TEST_F(ViewInput, APickedCellIsShownWhateverTheSource) {
  editor.cell = GridCell{4, 4};
  advance(editor, 0);
  const std::size_t fromVertices = rayCount();
  EXPECT_GT(fromVertices, 0u);
  editor.rays.source = RaySource::pixels;
  advance(editor, 0);
  EXPECT_EQ(rayCount(), fromVertices);
}

TEST_F(ViewInput, EveryCellOfTheGridCanBePicked) {
  const PixelGrid& grid = editor.session.level().grid;
  editor.rays.hideNoHit = false;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      editor.cell = GridCell{column, row};
      advance(editor, 0);
      EXPECT_GT(rayCount(), 0u) << column << ", " << row;
    }
  }
}

TEST_F(ViewInput, NothingIsShownOfASculptureThatCannotBe) {
  Level level = editor.session.level();
  level.camera.eye = pointAt(level.optic.shape(), 0.2, 0.6);
  editor.session.edit(level);
  finish();
  ASSERT_TRUE(editor.updater.result().problem);
  for (const RaySource source : {RaySource::vertices, RaySource::pixels}) {
    editor.rays.source = source;
    advance(editor, 0);
    EXPECT_EQ(rayCount(), 0u);
  }
}

TEST_F(ViewInput, NothingIsThereBeforeTheFirstResult) {
  Editor fresh({}, 1);
  openLevel(fresh, std::string(ANAMORPH_LEVELS) + "/1-plane.json");
  EXPECT_NO_THROW(maker.make(fresh, ui, ShownRays(fresh), false));
  EXPECT_EQ(ShownRays(fresh).animationSeconds(fresh.rays), 0);
}

TEST_F(ViewInput, AnimatedRaysGrowAndStartAgain) {
  editor.display.rtCamera = false;
  EXPECT_EQ(ShownRays(editor).animationSeconds(editor.rays), 0) << "nothing is animated";
  editor.rays.animate = true;
  const double length = ShownRays(editor).animationSeconds(editor.rays);
  ASSERT_GT(length, 0);
  EXPECT_TRUE(std::isfinite(length));
  const auto total = [&](double seconds) {
    editor.animationSeconds = seconds;
    double sum = 0;
    for (const Line& line : lines()) sum += glm::length(line.to - line.from);
    return sum;
  };
  EXPECT_LT(total(0.1 * length), total(0.5 * length));
  EXPECT_LT(total(0.5 * length), total(length));
  EXPECT_NEAR(total(length + 0.8 + 0.3 * length), total(0.3 * length), 1e-6) << "after a pause, again";
  editor.rays.loop = false;
  EXPECT_EQ(total(10 * length), total(length));
}

TEST_F(ViewInput, TransparentIsHandedOn) {
  EXPECT_FALSE(make().transparent);
  EXPECT_TRUE(maker.make(editor, ui, ShownRays(editor), true).transparent);
}

}  // namespace
}  // namespace anamorph
