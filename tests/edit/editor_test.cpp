#include "edit/editor.h"

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"
#include "edit/advance.h"
#include "edit/morph.h"
#include "edit/orbit.h"
#include "optics/camera.h"
#include "pipeline/changing_levels.h"
#include "pipeline/stages.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace testing;

const std::filesystem::path levels = ANAMORPH_LEVELS;

/// With a small original and small pictures, so that updates are quick.
void openQuick(Editor& editor, const std::string& name) {
  openLevel(editor, levels / (name + ".json"));
  Level level = editor.session.level();
  std::get<BoxShape>(level.original.shape).segments = 4;
  level.sculpture.tolerancePixels = 1;
  editor.session.edit(level);
  editor.preview.size = 24;
}

void finish(Editor& editor) {
  editor.updater.finish(editor.session, {editor.preview.size, false});
}

double distance(const ViewPose& a, const ViewPose& b) {
  return glm::length(a.eye - b.eye) + glm::length(a.target - b.target);
}

void advanceUntilStill(Editor& editor, double step = 0.016) {
  int frames = 0;
  while (editor.flight) {
    ASSERT_TRUE(isMoving(editor));
    advance(editor, step);
    ASSERT_LT(++frames, 1000);
  }
  EXPECT_FALSE(isMoving(editor));
}

void expectSeenByTheRtCamera(const Editor& editor) {
  const Level& level = editor.session.level();
  const Camera& camera = level.camera;
  EXPECT_EQ(editor.pose, lookThroughPose(camera, level.grid, editor.viewWidth, editor.viewHeight));
  EXPECT_EQ(editor.pose.eye, camera.eye);
  const ViewProjection view(editor.pose, editor.viewWidth, editor.viewHeight);
  const Projection rt(camera, editor.viewWidth, editor.viewHeight);
  for (const Pixel& pixel : {Pixel(0, 0), Pixel(100, 300), Pixel(640, 480)}) {
    EXPECT_LT(glm::length(view.rayThrough(pixel).direction - glm::normalize(rt.rayThrough(pixel).direction)),
              1e-12);
  }
}

TEST(Editor, FlightsEndExactlyAtTheirGoal) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Editor editor;
    const ViewPose goal{random.point(20), random.point(5)};
    flyTo(editor, goal);
    if (seed % 2 == 0) {  // another goal on the way
      advance(editor, 0.1);
      const ViewPose before = editor.pose;
      flyTo(editor, goal);
      advance(editor, 0);
      EXPECT_LT(distance(before, editor.pose), 1e-9) << "no jump";
    }
    double seconds = 0;
    while (editor.flight) {
      const double step = random.uniform(0.001, 0.05);
      advance(editor, step);
      seconds += step;
    }
    EXPECT_EQ(editor.pose, goal);
    EXPECT_LT(seconds, 0.3);
    EXPECT_FALSE(isMoving(editor));
    const ViewPose rest = editor.pose;
    advance(editor, 1);
    EXPECT_EQ(editor.pose, rest);
  }
}

TEST(Editor, AtRestNothingChanges) {
  Editor editor({}, 2);
  openQuick(editor, "1-plane");
  finish(editor);
  advance(editor, 0.016);  // takes up the level's lesson
  EXPECT_FALSE(advance(editor, 0.016));
  EXPECT_FALSE(isMoving(editor));
}

TEST(Editor, LooksThroughTheRtCameraAndComesBack) {
  Editor editor({}, 2);
  openQuick(editor, "2-cylinder");
  const ViewPose before = editor.pose;
  toggleLookThrough(editor);
  EXPECT_TRUE(editor.lookingThrough);
  advanceUntilStill(editor);
  expectSeenByTheRtCamera(editor);
  EXPECT_TRUE(editor.lookingThrough);
  toggleLookThrough(editor);
  EXPECT_FALSE(editor.lookingThrough);
  advanceUntilStill(editor);
  EXPECT_EQ(editor.pose, before);
}

TEST(Editor, StaysWithTheRtCameraWhileThatMoves) {
  Editor editor({}, 2);
  openQuick(editor, "2-cylinder");
  const ViewPose before = editor.pose;
  const auto moveCamera = [&] {
    Level level = editor.session.level();
    level.camera.eye += Vector(0.1, -0.05, 0.02);
    level.camera.target.x += 0.03;
    level.camera.fovDegrees -= 0.1;
    editor.session.change(level);
  };
  toggleLookThrough(editor);
  for (int i = 0; i < 6; ++i) {  // on the way there
    moveCamera();
    advance(editor, 0.02);
  }
  EXPECT_TRUE(editor.flight);
  advanceUntilStill(editor);
  expectSeenByTheRtCamera(editor);
  for (int i = 0; i < 3; ++i) {  // and there
    moveCamera();
    EXPECT_TRUE(advance(editor, 0.016));
    expectSeenByTheRtCamera(editor);
  }
  editor.viewWidth = 300;  // and when the view is reshaped
  advance(editor, 0.016);
  EXPECT_EQ(editor.pose,
            lookThroughPose(editor.session.level().camera, editor.session.level().grid, 300, 480));
  toggleLookThrough(editor);
  for (int i = 0; i < 3; ++i) {
    moveCamera();
    advance(editor, 0.02);
  }
  advanceUntilStill(editor);
  EXPECT_EQ(editor.pose, before);
  moveCamera();
  advance(editor, 0.016);
  EXPECT_EQ(editor.pose, before);
}

TEST(Editor, TogglingAtAnyTimeNeverLosesThePlaceToGoBackTo) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Editor editor({}, 1);
    openQuick(editor, "1-plane");
    editor.updater.cancel();
    ViewPose home = editor.pose;
    if (seed % 3 == 0) {
      home = viewFrom(editor.pose, ViewSide::top);
      flyTo(editor, home);
    }
    for (int i = random.integer(1, 9); i > 0; --i) {
      toggleLookThrough(editor);
      for (int frame = random.integer(0, 12); frame > 0; --frame) advance(editor, 0.03);
    }
    advanceUntilStill(editor);
    if (editor.lookingThrough) {
      expectSeenByTheRtCamera(editor);
      toggleLookThrough(editor);
      advanceUntilStill(editor);
    }
    EXPECT_EQ(editor.pose, home);
  }
}

TEST(Editor, TurningTheViewByHandEndsFlightAndLookingThrough) {
  Editor editor({}, 2);
  openQuick(editor, "1-plane");
  toggleLookThrough(editor);
  advance(editor, 0.05);
  const ViewPose there = editor.pose;
  takeOverView(editor);
  EXPECT_FALSE(isMoving(editor));
  advance(editor, 1);
  EXPECT_EQ(editor.pose, there);
  EXPECT_FALSE(editor.lookingThrough);
}

TEST(Editor, SelectionsThatAreGoneAreDropped) {
  Editor editor({}, 2);
  openQuick(editor, "1-plane");
  editor.selection = {Part::light, 1};
  editor.cell = GridCell{7, 7};
  advance(editor, 0);
  EXPECT_EQ(editor.selection, (Selection{Part::light, 1}));
  EXPECT_EQ(editor.cell, (GridCell{7, 7}));

  Level level = editor.session.level();
  level.lights.resize(1);
  level.grid.rows = 4;
  editor.session.edit(level);
  advance(editor, 0);
  EXPECT_EQ(editor.selection, Selection());
  EXPECT_EQ(editor.cell, std::nullopt);

  editor.selection = {Part::light, -1};
  advance(editor, 0);
  EXPECT_EQ(editor.selection, Selection());

  for (const Part part : {Part::eye, Part::aim, Part::original, Part::mirror, Part::sculpture}) {
    editor.selection = {part};
    advance(editor, 0);
    EXPECT_EQ(editor.selection.part, part);
  }
  editor.cell = GridCell{7, 3};
  advance(editor, 0);
  EXPECT_EQ(editor.cell, (GridCell{7, 3}));
}

TEST(Editor, OpeningStartsAfresh) {
  Editor editor({}, 2);
  openQuick(editor, "1-plane");
  editor.selection = {Part::mirror};
  editor.cell = GridCell{1, 1};
  editor.point = PickedPoint{};
  editor.display.morph = 0.3;
  editor.animationSeconds = 3;
  toggleLookThrough(editor);
  openLevel(editor, levels / "3-sphere.json");
  const ViewSettings& view = editor.session.level().view;
  EXPECT_EQ(editor.pose.eye, view.eye);
  EXPECT_EQ(editor.pose.target, view.target);
  EXPECT_EQ(editor.pose.fovDegrees, view.fovDegrees);
  EXPECT_EQ(editor.selection, Selection());
  EXPECT_FALSE(editor.cell || editor.point || editor.lookingThrough || editor.flight);
  EXPECT_EQ(editor.display.morph, 1);
  EXPECT_EQ(editor.animationSeconds, 0);
}

TEST(Editor, FailingToOpenChangesNothing) {
  Editor editor({}, 2);
  openQuick(editor, "1-plane");
  editor.selection = {Part::mirror};
  editor.point = PickedPoint{};
  editor.display.morph = 0.3;
  editor.status.say("hello");
  toggleLookThrough(editor);
  const Level level = editor.session.level();
  const ViewPose pose = editor.pose;
  EXPECT_THROW(openLevel(editor, levels / "nothing.json"), Error);
  EXPECT_EQ(editor.session.level(), level);
  EXPECT_EQ(editor.pose, pose);
  EXPECT_EQ(editor.selection.part, Part::mirror);
  EXPECT_TRUE(editor.point && editor.lookingThrough && editor.flight);
  EXPECT_EQ(editor.display.morph, 0.3);
  EXPECT_EQ(editor.status.text(), "hello");
}

TEST(Editor, AllOfTheSceneIsWithoutItsLights) {
  Editor editor({}, 2);
  openQuick(editor, "1-plane");
  finish(editor);
  const Box box = boxOf(editor, Selection{});
  Level level = editor.session.level();
  level.lights.front().position = {1e5, 0, 1e5};
  editor.session.edit(level);
  finish(editor);
  EXPECT_EQ(boxOf(editor, Selection{}), box);
}

TEST(Editor, RaysAreAnimatedUnlessPausedOrHidden) {
  Editor editor({}, 2);
  openQuick(editor, "1-plane");
  finish(editor);
  editor.rays.animate = true;
  EXPECT_TRUE(isMoving(editor));
  EXPECT_TRUE(advance(editor, 0.25));
  EXPECT_EQ(editor.animationSeconds, 0.25);
  editor.animationPaused = true;
  EXPECT_FALSE(isMoving(editor));
  EXPECT_FALSE(advance(editor, 0.25));
  editor.animationPaused = false;
  editor.rays.show = false;
  EXPECT_FALSE(isMoving(editor));
  EXPECT_FALSE(advance(editor, 0.25));
  EXPECT_EQ(editor.animationSeconds, 0.25);
}

TEST(Editor, TreesAreMadeForWhatIsShown) {
  Editor editor({}, 2);
  openQuick(editor, "1-plane");
  finish(editor);
  const auto hasTrees = [&] {
    advance(editor, 0);
    return editor.updater.result().trees != nullptr;
  };
  EXPECT_FALSE(hasTrees()) << "vertex rays need none";
  editor.cell = GridCell{1, 2};
  EXPECT_TRUE(hasTrees());
  editor.cell.reset();
  editor.rays.source = RaySource::pixels;
  EXPECT_TRUE(hasTrees());
  editor.rays.show = false;
  EXPECT_FALSE(hasTrees());
}

bool contains(const Box& box, const Box& other) {
  return glm::min(box.min, other.min) == box.min && glm::max(box.max, other.max) == box.max;
}

TEST(Editor, BoxOfNothingIsThatOfEverything) {
  Editor editor({}, 2);
  EXPECT_FALSE(boxOf(editor, {}).empty()) << "the mirror at least";
  openQuick(editor, "3-sphere");
  finish(editor);
  const Box all = boxOf(editor, {});
  for (const Part part : {Part::original, Part::sculpture, Part::mirror}) {
    const Box box = boxOf(editor, {part});
    EXPECT_FALSE(box.empty());
    EXPECT_TRUE(contains(all, box)) << int(part);
  }
  Box eye;
  eye.extend(editor.session.level().camera.eye);
  EXPECT_TRUE(contains(all, eye));
}

TEST(Editor, ConstructionIsThatOfThePickedPointInTheLevelAsItIs) {
  Editor editor({}, 2);
  openQuick(editor, "2-cylinder");
  EXPECT_FALSE(currentConstruction(editor)) << "nothing is picked";
  editor.point = PickedPoint{3, 1, 0};
  EXPECT_FALSE(currentConstruction(editor)) << "nothing is there yet";
  finish(editor);
  for (int i = 0; i < 3; ++i) {
    const LevelResult& result = editor.updater.result();
    const auto construction = currentConstruction(editor);
    ASSERT_TRUE(construction);
    const Level& level = editor.session.level();
    const Point original = result.original.mesh->positions[result.original.mesh->triangles[3][1]];
    const VertexRay ray = makeVertexRay(makeVertexMap(level), original);
    EXPECT_EQ(construction->ray.original, original);
    EXPECT_EQ(construction->ray.sculpture, ray.sculpture);
    Level next = level;
    next.camera.eye.x += 0.2;
    next.original.placement.position.y += 0.1;
    editor.session.change(next);
    advance(editor, 0.016);
  }
  Level flat = editor.session.level();
  changeShape<CylinderMirror>(flat.optic.shape(), [](auto& s) { s.radius = 0; });
  editor.session.change(flat);
  advance(editor, 0.016);
  EXPECT_FALSE(currentConstruction(editor)) << "there is no mirror";
  editor.session.cancelChange();
  editor.point = PickedPoint{1'000'000, 0, 0};
  advance(editor, 0.016);
  EXPECT_FALSE(currentConstruction(editor)) << "not on this original";
}

TEST(Editor, MorphGoesFromTheOriginalToTheSculpture) {
  Editor editor({}, 2);
  openQuick(editor, "2-cylinder");
  EXPECT_EQ(shownSculpture(editor).sculpture, nullptr);
  finish(editor);
  const LevelResult& result = editor.updater.result();
  const Sculpture& whole = *result.sculpture.sculpture;
  EXPECT_EQ(shownSculpture(editor), result.sculpture);
  editor.display.morph = 0;
  const PreparedSculpture start = shownSculpture(editor);
  EXPECT_EQ(start.sculpture->mesh.positions, whole.original);
  EXPECT_EQ(start.sculpture->mesh.triangles, whole.mesh.triangles);
  EXPECT_EQ(shownSculpture(editor), start) << "kept";
  const Mesh copy = start.sculpture->mesh;
  for (const double fraction : {0.25, 0.5, 0.75}) {
    editor.display.morph = fraction;
    const PreparedSculpture on = shownSculpture(editor);
    EXPECT_EQ(on.sculpture->mesh.positions, morphPoints(whole, makeVertexMap(result.level), fraction));
    EXPECT_EQ(*on.prepared.normals,
              computeNormals(on.sculpture->mesh.positions, whole.mesh.triangles, *on.prepared.normalGroups));
    EXPECT_EQ(on.prepared.mesh.get(), &on.sculpture->mesh);
    const Triangle& t = whole.mesh.triangles[5];
    const PointArray& p = on.sculpture->mesh.positions;
    const Point middle = (p[t[0]] + p[t[1]] + p[t[2]]) / 3.0;
    const Direction n = glm::normalize(areaVector(p, t));
    EXPECT_TRUE(on.prepared.bvh->anyHit({middle + 1e-3 * n, -n}, 0, 2e-3));
  }
  EXPECT_EQ(start.sculpture->mesh, copy) << "what is held stays";
  editor.display.morph = 1;
  EXPECT_EQ(shownSculpture(editor), result.sculpture);
}

TEST(Editor, MorphFollowsADrag) {
  Editor editor({}, 2);
  openQuick(editor, "1-plane");
  finish(editor);
  editor.display.morph = 0.7;  // at 0.5 all is in the mirror's plane
  for (int i = 0; i < 6; ++i) {
    Level level = editor.session.level();
    level.original.placement.position.x +=
        0.61;  // until a part is not mapped; no side is ever in a plane with the eye
    editor.session.change(level);
    advance(editor, 0.016);
    const Sculpture& whole = *editor.updater.result().sculpture.sculpture;
    const PreparedSculpture shown = shownSculpture(editor);
    const Sculpture& on = *shown.sculpture;
    EXPECT_EQ(on.original, whole.original);
    EXPECT_EQ(on.status, whole.status);
    EXPECT_EQ(on.originalStatus, whole.originalStatus);
    EXPECT_EQ(on.mesh.triangles, whole.mesh.triangles);
    EXPECT_EQ(on.mesh.positions, morphPoints(whole, makeVertexMap(level), 0.7));
    int unmapped = 0;
    for (std::uint32_t t = 0; t < on.mesh.triangles.size(); ++t) {
      const Triangle& corners = on.mesh.triangles[t];
      bool mapped = true;
      for (const std::uint32_t corner : corners) mapped &= on.status[corner] == PathStatus::mapped;
      unmapped += !mapped;
      const Vector area = areaVector(on.mesh.positions, corners);
      if (glm::length(area) < 1e-6) continue;
      const Point middle =
          (on.mesh.positions[corners[0]] + on.mesh.positions[corners[1]] + on.mesh.positions[corners[2]]) /
          3.0;
      const Direction n = glm::normalize(area);
      BvhHit hit;
      const bool found =
          shown.prepared.bvh->closestHit({middle + 1e-5 * n, -n}, hit, 0, 2e-5) && hit.triangle == t;
      EXPECT_EQ(found, mapped) << t;
    }
    EXPECT_EQ(unmapped > 0,
              whole.originalStatus[0] < editor.updater.result().original.mesh->positions.size());
    EXPECT_TRUE(i < 5 || unmapped > 0);
  }
}

TEST(Editor, MorphTakesAnotherOriginal) {
  Editor editor({}, 2);
  openQuick(editor, "1-plane");
  finish(editor);
  editor.display.morph = 0.5;
  shownSculpture(editor);
  Level level = editor.session.level();
  level.original.shape = SphereShape{1, 12};
  editor.session.edit(level);
  finish(editor);
  const Sculpture& whole = *editor.updater.result().sculpture.sculpture;
  EXPECT_EQ(shownSculpture(editor).sculpture->mesh.triangles, whole.mesh.triangles);
  editor.display.morph = 0;
  EXPECT_EQ(shownSculpture(editor).sculpture->mesh.positions, whole.original);
  // And a level without a sculpture shows none.
  level.original.placement.position.x = 500;
  editor.session.edit(level);
  finish(editor);
  EXPECT_TRUE(shownSculpture(editor).sculpture->mesh.triangles.empty());
}

}  // namespace
}  // namespace anamorph
