#include "edit/workspace.h"

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"
#include "edit/morph.h"
#include "edit/orbit.h"
#include "optics/camera.h"
#include "pipeline/changing_levels.h"

namespace anamorph {
namespace {

using namespace testing;

const std::filesystem::path levels = ANAMORPH_LEVELS;

/// With a small original and small pictures, so that updates are quick.
void openQuick(Workspace& work, const std::string& name) {
  openLevel(work, levels / (name + ".json"));
  Level level = work.session.level();
  std::get<BoxShape>(level.original.shape).segments = 4;
  level.sculpture.tolerancePixels = 1;
  work.session.edit(level);
  work.preview.size = 24;
}

void finish(Workspace& work) {
  work.studio.finish(work.session, {work.preview.size, false});
}

double distance(const ViewPose& a, const ViewPose& b) {
  return glm::length(a.eye - b.eye) + glm::length(a.target - b.target);
}

void advanceUntilStill(Workspace& work, double step = 0.016) {
  int frames = 0;
  while (work.flight) {
    ASSERT_TRUE(isMoving(work));
    advance(work, step);
    ASSERT_LT(++frames, 1000);
  }
  EXPECT_FALSE(isMoving(work));
}

void expectSeenByTheRtCamera(const Workspace& work) {
  const Camera& camera = work.session.level().camera;
  EXPECT_EQ(work.pose, lookThroughPose(camera, work.viewWidth, work.viewHeight));
  EXPECT_EQ(work.pose.eye, camera.eye);
  const ViewProjection view(work.pose, work.viewWidth, work.viewHeight);
  const Projection rt(camera, work.viewWidth, work.viewHeight);
  for (const Pixel& pixel : {Pixel(0, 0), Pixel(100, 300), Pixel(640, 480)}) {
    EXPECT_LT(glm::length(view.rayThrough(pixel).direction - glm::normalize(rt.rayThrough(pixel).direction)),
              1e-12);
  }
}

TEST(Workspace, FlightsEndExactlyAtTheirGoal) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Workspace work;
    const ViewPose goal{random.point(20), random.point(5)};
    flyTo(work, goal);
    if (seed % 2 == 0) {  // another goal on the way
      advance(work, 0.1);
      const ViewPose before = work.pose;
      flyTo(work, goal);
      advance(work, 0);
      EXPECT_LT(distance(before, work.pose), 1e-9) << "no jump";
    }
    double seconds = 0;
    while (work.flight) {
      const double step = random.uniform(0.001, 0.05);
      advance(work, step);
      seconds += step;
    }
    EXPECT_EQ(work.pose, goal);
    EXPECT_LT(seconds, 0.3);
    EXPECT_FALSE(isMoving(work));
    const ViewPose rest = work.pose;
    advance(work, 1);
    EXPECT_EQ(work.pose, rest);
  }
}

TEST(Workspace, AtRestNothingChanges) {
  Workspace work({}, 2);
  openQuick(work, "1-plane");
  finish(work);
  advance(work, 0.016);  // takes up the level's lesson
  EXPECT_FALSE(advance(work, 0.016));
  EXPECT_FALSE(isMoving(work));
}

TEST(Workspace, LooksThroughTheRtCameraAndComesBack) {
  Workspace work({}, 2);
  openQuick(work, "2-cylinder");
  const ViewPose before = work.pose;
  toggleLookThrough(work);
  EXPECT_TRUE(work.lookingThrough);
  advanceUntilStill(work);
  expectSeenByTheRtCamera(work);
  EXPECT_TRUE(work.lookingThrough);
  toggleLookThrough(work);
  EXPECT_FALSE(work.lookingThrough);
  advanceUntilStill(work);
  EXPECT_EQ(work.pose, before);
}

TEST(Workspace, StaysWithTheRtCameraWhileThatMoves) {
  Workspace work({}, 2);
  openQuick(work, "2-cylinder");
  const ViewPose before = work.pose;
  const auto moveCamera = [&] {
    Level level = work.session.level();
    level.camera.eye += Vector(0.1, -0.05, 0.02);
    level.camera.target.x += 0.03;
    level.camera.fovDegrees -= 0.1;
    work.session.change(level);
  };
  toggleLookThrough(work);
  for (int i = 0; i < 6; ++i) {  // on the way there
    moveCamera();
    advance(work, 0.02);
  }
  EXPECT_TRUE(work.flight);
  advanceUntilStill(work);
  expectSeenByTheRtCamera(work);
  for (int i = 0; i < 3; ++i) {  // and there
    moveCamera();
    EXPECT_TRUE(advance(work, 0.016));
    expectSeenByTheRtCamera(work);
  }
  work.viewWidth = 300;  // and when the view is reshaped
  advance(work, 0.016);
  EXPECT_EQ(work.pose, lookThroughPose(work.session.level().camera, 300, 480));
  toggleLookThrough(work);
  for (int i = 0; i < 3; ++i) {
    moveCamera();
    advance(work, 0.02);
  }
  advanceUntilStill(work);
  EXPECT_EQ(work.pose, before);
  moveCamera();
  advance(work, 0.016);
  EXPECT_EQ(work.pose, before);
}

TEST(Workspace, TogglingAtAnyTimeNeverLosesThePlaceToGoBackTo) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Workspace work({}, 1);
    openQuick(work, "1-plane");
    work.studio.cancel();
    ViewPose home = work.pose;
    if (seed % 3 == 0) {
      home = viewFrom(work.pose, ViewSide::top);
      flyTo(work, home);
    }
    for (int i = random.integer(1, 9); i > 0; --i) {
      toggleLookThrough(work);
      for (int frame = random.integer(0, 12); frame > 0; --frame) advance(work, 0.03);
    }
    advanceUntilStill(work);
    if (work.lookingThrough) {
      expectSeenByTheRtCamera(work);
      toggleLookThrough(work);
      advanceUntilStill(work);
    }
    EXPECT_EQ(work.pose, home);
  }
}

TEST(Workspace, TurningTheViewByHandEndsFlightAndLookingThrough) {
  Workspace work({}, 2);
  openQuick(work, "1-plane");
  toggleLookThrough(work);
  advance(work, 0.05);
  const ViewPose there = work.pose;
  takeOverView(work);
  EXPECT_FALSE(isMoving(work));
  advance(work, 1);
  EXPECT_EQ(work.pose, there);
  EXPECT_FALSE(work.lookingThrough);
}

TEST(Workspace, SelectionsThatAreGoneAreDropped) {
  Workspace work({}, 2);
  openQuick(work, "1-plane");
  work.selection = {Part::light, 1};
  work.cell = GridCell{7, 7};
  advance(work, 0);
  EXPECT_EQ(work.selection, (Selection{Part::light, 1}));
  EXPECT_EQ(work.cell, (GridCell{7, 7}));

  Level level = work.session.level();
  level.lights.resize(1);
  level.camera.gridRows = 4;
  work.session.edit(level);
  advance(work, 0);
  EXPECT_EQ(work.selection, Selection());
  EXPECT_EQ(work.cell, std::nullopt);

  work.selection = {Part::light, -1};
  advance(work, 0);
  EXPECT_EQ(work.selection, Selection());

  for (const Part part : {Part::eye, Part::aim, Part::original, Part::mirror, Part::sculpture}) {
    work.selection = {part};
    advance(work, 0);
    EXPECT_EQ(work.selection.part, part);
  }
  work.cell = GridCell{7, 3};
  advance(work, 0);
  EXPECT_EQ(work.cell, (GridCell{7, 3}));
}

TEST(Workspace, OpeningStartsAfresh) {
  Workspace work({}, 2);
  openQuick(work, "1-plane");
  work.selection = {Part::mirror};
  work.cell = GridCell{1, 1};
  work.point = PickedPoint{};
  work.display.morph = 0.3;
  work.animationSeconds = 3;
  toggleLookThrough(work);
  openLevel(work, levels / "3-sphere.json");
  const ViewSettings& view = work.session.level().view;
  EXPECT_EQ(work.pose.eye, view.eye);
  EXPECT_EQ(work.pose.target, view.target);
  EXPECT_EQ(work.pose.fovDegrees, view.fovDegrees);
  EXPECT_EQ(work.selection, Selection());
  EXPECT_FALSE(work.cell || work.point || work.lookingThrough || work.flight);
  EXPECT_EQ(work.display.morph, 1);
  EXPECT_EQ(work.animationSeconds, 0);
}

TEST(Workspace, FailingToOpenChangesNothing) {
  Workspace work({}, 2);
  openQuick(work, "1-plane");
  work.selection = {Part::mirror};
  work.point = PickedPoint{};
  work.display.morph = 0.3;
  work.message = "hello";
  toggleLookThrough(work);
  const Level level = work.session.level();
  const ViewPose pose = work.pose;
  EXPECT_THROW(openLevel(work, levels / "nothing.json"), Error);
  EXPECT_EQ(work.session.level(), level);
  EXPECT_EQ(work.pose, pose);
  EXPECT_EQ(work.selection.part, Part::mirror);
  EXPECT_TRUE(work.point && work.lookingThrough && work.flight);
  EXPECT_EQ(work.display.morph, 0.3);
  EXPECT_EQ(work.message, "hello");
}

TEST(Workspace, RaysAreAnimatedUnlessPausedOrHidden) {
  Workspace work({}, 2);
  openQuick(work, "1-plane");
  finish(work);
  work.rays.animate = true;
  EXPECT_TRUE(isMoving(work));
  EXPECT_TRUE(advance(work, 0.25));
  EXPECT_EQ(work.animationSeconds, 0.25);
  work.animationPaused = true;
  EXPECT_FALSE(isMoving(work));
  EXPECT_FALSE(advance(work, 0.25));
  work.animationPaused = false;
  work.rays.show = false;
  EXPECT_FALSE(isMoving(work));
  EXPECT_FALSE(advance(work, 0.25));
  EXPECT_EQ(work.animationSeconds, 0.25);
}

TEST(Workspace, TreesAreMadeForWhatIsShown) {
  Workspace work({}, 2);
  openQuick(work, "1-plane");
  finish(work);
  const auto hasTrees = [&] {
    advance(work, 0);
    return work.studio.products().trees != nullptr;
  };
  EXPECT_FALSE(hasTrees()) << "vertex rays need none";
  work.cell = GridCell{1, 2};
  EXPECT_TRUE(hasTrees());
  work.cell.reset();
  work.rays.source = RaySource::pixels;
  EXPECT_TRUE(hasTrees());
  work.rays.show = false;
  EXPECT_FALSE(hasTrees());
}

bool contains(const Box& box, const Box& other) {
  return glm::min(box.min, other.min) == box.min && glm::max(box.max, other.max) == box.max;
}

TEST(Workspace, BoxOfNothingIsThatOfEverything) {
  Workspace work({}, 2);
  EXPECT_FALSE(boxOf(work, {}).empty()) << "the mirror at least";
  openQuick(work, "3-sphere");
  finish(work);
  const Box all = boxOf(work, {});
  for (const Part part : {Part::original, Part::sculpture, Part::mirror}) {
    const Box box = boxOf(work, {part});
    EXPECT_FALSE(box.empty());
    EXPECT_TRUE(contains(all, box)) << int(part);
  }
  Box eye;
  eye.extend(work.session.level().camera.eye);
  EXPECT_TRUE(contains(all, eye));
}

TEST(Workspace, ConstructionIsThatOfThePickedPointInTheLevelAsItIs) {
  Workspace work({}, 2);
  openQuick(work, "2-cylinder");
  EXPECT_FALSE(currentConstruction(work)) << "nothing is picked";
  work.point = PickedPoint{3, 1, 0};
  EXPECT_FALSE(currentConstruction(work)) << "nothing is there yet";
  finish(work);
  for (int i = 0; i < 3; ++i) {
    const Products& products = work.studio.products();
    const auto construction = currentConstruction(work);
    ASSERT_TRUE(construction);
    const Level& level = work.session.level();
    const Point original = products.original.mesh->positions[products.original.mesh->triangles[3][1]];
    const VertexRay ray = makeVertexRay(level.optic, level.camera.eye, original, level.sculpture.depthScale);
    EXPECT_EQ(construction->ray.original, original);
    EXPECT_EQ(construction->ray.sculpture, ray.sculpture);
    Level next = level;
    next.camera.eye.x += 0.2;
    next.original.placement.position.y += 0.1;
    work.session.change(next);
    advance(work, 0.016);
  }
  Level flat = work.session.level();
  std::get<CylinderMirror>(flat.optic.shape).radius = 0;
  work.session.change(flat);
  advance(work, 0.016);
  EXPECT_FALSE(currentConstruction(work)) << "there is no mirror";
  work.session.cancelChange();
  work.point = PickedPoint{1'000'000, 0, 0};
  advance(work, 0.016);
  EXPECT_FALSE(currentConstruction(work)) << "not on this original";
}

TEST(Workspace, MorphGoesFromTheOriginalToTheSculpture) {
  Workspace work({}, 2);
  openQuick(work, "2-cylinder");
  EXPECT_EQ(shownSculpture(work).sculpture, nullptr);
  finish(work);
  const Products& products = work.studio.products();
  const Sculpture& whole = *products.sculpture.sculpture;
  EXPECT_EQ(shownSculpture(work), products.sculpture);
  work.display.morph = 0;
  const PreparedSculpture start = shownSculpture(work);
  EXPECT_EQ(start.sculpture->mesh.positions, whole.original);
  EXPECT_EQ(start.sculpture->mesh.triangles, whole.mesh.triangles);
  EXPECT_EQ(shownSculpture(work), start) << "kept";
  const Mesh copy = start.sculpture->mesh;
  for (const double share : {0.25, 0.5, 0.75}) {
    work.display.morph = share;
    const PreparedSculpture on = shownSculpture(work);
    EXPECT_EQ(on.sculpture->mesh.positions,
              morphPoints(whole, products.level.optic, products.level.camera.eye, share));
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
  work.display.morph = 1;
  EXPECT_EQ(shownSculpture(work), products.sculpture);
}

TEST(Workspace, MorphFollowsADrag) {
  Workspace work({}, 2);
  openQuick(work, "1-plane");
  finish(work);
  work.display.morph = 0.7;  // at 0.5 all is in the mirror's plane
  for (int i = 0; i < 6; ++i) {
    Level level = work.session.level();
    level.original.placement.position.x += 0.6;  // until a part of it is not mapped
    work.session.change(level);
    advance(work, 0.016);
    const Sculpture& whole = *work.studio.products().sculpture.sculpture;
    const PreparedSculpture shown = shownSculpture(work);
    const Sculpture& on = *shown.sculpture;
    EXPECT_EQ(on.original, whole.original);
    EXPECT_EQ(on.status, whole.status);
    EXPECT_EQ(on.originalStatus, whole.originalStatus);
    EXPECT_EQ(on.mesh.triangles, whole.mesh.triangles);
    EXPECT_EQ(on.mesh.positions, morphPoints(whole, level.optic, level.camera.eye, 0.7));
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
    EXPECT_EQ(unmapped > 0, whole.originalStatus[0] < work.studio.products().original.mesh->positions.size());
    EXPECT_TRUE(i < 5 || unmapped > 0);
  }
}

TEST(Workspace, MorphTakesAnotherOriginal) {
  Workspace work({}, 2);
  openQuick(work, "1-plane");
  finish(work);
  work.display.morph = 0.5;
  shownSculpture(work);
  Level level = work.session.level();
  level.original.shape = SphereShape{1, 12};
  work.session.edit(level);
  finish(work);
  const Sculpture& whole = *work.studio.products().sculpture.sculpture;
  EXPECT_EQ(shownSculpture(work).sculpture->mesh.triangles, whole.mesh.triangles);
  work.display.morph = 0;
  EXPECT_EQ(shownSculpture(work).sculpture->mesh.positions, whole.original);
  // And a level without a sculpture shows none.
  level.original.placement.position.x = 500;
  work.session.edit(level);
  finish(work);
  EXPECT_TRUE(shownSculpture(work).sculpture->mesh.triangles.empty());
}

}  // namespace
}  // namespace anamorph
