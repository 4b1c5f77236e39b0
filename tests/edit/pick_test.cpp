#include "edit/pick.h"

#include <gtest/gtest.h>

#include "edit/camera_body.h"
#include "edit/edit_levels.h"
#include "geometry/shapes.h"
#include "pipeline/original.h"

namespace anamorph {
namespace {

using namespace testing;

// A level with all that is made of it, seen in a picture of 800 x 600.
struct Made {
  explicit Made(Level made, double tolerance = 0) : level(std::move(made)) {
    level.sculpture.tolerancePixels = tolerance;
    original = prepareMesh(placeOriginal(makeBox({6, 2, 2}, 8), false, level.original.placement));
    sculpture = prepareSculpture(makeSculpture(makeDeformInput(level, original.mesh)));
    display.rtCamera = false;
    display.lightMarkers = false;
  }
  Pick at(const ViewPose& pose, const Pixel& pixel) const {
    return pick({ViewProjection(pose, 800, 600), level, original, sculpture, display, selection}, pixel);
  }
  Pick at(const ViewPose& pose, const Point& point) const {
    return at(pose, *ViewProjection(pose, 800, 600).pixelOf(point));
  }

  Level level;
  PreparedMesh original;
  PreparedSculpture sculpture;
  DisplaySettings display;
  Selection selection;
};

TEST(Pick, FindsTheVerticesOfTheSculpture) {
  for (const double tolerance : {0.0, 0.5}) {  // its own vertices, and refined ones
    const Made made(Level{}, tolerance);
    const Sculpture& sculpture = *made.sculpture.sculpture;
    int found = 0;
    for (unsigned seed = 0; seed < 300; ++seed) {
      SCOPED_TRACE(seed);
      Random random(seed);
      const std::size_t vertex = std::size_t(random.integer(0, int(sculpture.original.size()) - 1));
      const Point seen = sculpture.mesh.positions[vertex];
      ViewPose pose{Point(0, -3, 1) + 15.0 * random.direction(), seen};
      pose.orthographic = seed % 2 == 1;
      const Pick picked = made.at(pose, seen);
      if (picked.selection.part != Part::sculpture || glm::length(picked.where - seen) > 1e-3)
        continue;  // hidden
      ++found;
      ASSERT_TRUE(picked.point);
      ASSERT_TRUE(isOn(*made.original.mesh, *picked.point));
      const Point original = pointOn(*made.original.mesh, *picked.point);
      EXPECT_LT(glm::length(original - sculpture.original[vertex]), 1e-9);
      EXPECT_LT(glm::length(ViewProjection(pose, 800, 600).rayThrough({400, 300}).at(picked.distance) - seen),
                1e-3);
    }
    EXPECT_GT(found, 60);
  }
}

TEST(Pick, FindsTheVerticesOfTheOriginal) {
  Made made(Level{});
  made.display.originalLook = OriginalLook::solid;
  const Mesh& mesh = *made.original.mesh;
  int found = 0;
  for (std::uint32_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    const Point seen = mesh.positions[vertex];
    const ViewPose pose{{5, 14, 8}, seen};  // from behind the mirror
    const Pick picked = made.at(pose, seen + 1e-4 * (Point(0, 3.4, 1) - seen));
    if (picked.selection.part != Part::original || glm::length(picked.where - seen) > 0.01)
      continue;  // behind
    ++found;
    EXPECT_EQ(pointOn(mesh, *picked.point), seen);
  }
  EXPECT_GT(found, 100);
}

TEST(Pick, AGhostIsPickedThroughTheMirrorOnly) {
  Made made(Level{});
  const ViewPose front{{0, -14, 1}, {0, 3.4, 1}};
  EXPECT_EQ(made.at(front, Point(0, 3.4, 1)).selection.part, Part::sculpture)
      << "it stands before mirror and ghost";
  made.display.sculpture = false;
  EXPECT_EQ(made.at(front, Point(0, 3.4, 1)).selection.part, Part::original);
  made.display.originalLook = OriginalLook::solid;
  EXPECT_EQ(made.at(front, Point(0, 3.4, 1)).selection.part, Part::mirror);
  made.display.originalLook = OriginalLook::hidden;
  EXPECT_EQ(made.at(front, Point(0, 3.4, 1)).selection.part, Part::mirror);
  EXPECT_EQ(made.at(front, Point(0, 0, 30)).selection.part, Part::none);
}

TEST(Pick, TheBodyOfTheRtCameraIsTheEye) {
  Made made(Level{});
  made.display.rtCamera = true;
  const Camera& camera = made.level.camera;
  const double radius = measureScene(boxOf(makeReflectionScene(made.level, made.sculpture))).radius;
  const double size = rtCameraSize(made.level.grid, radius);
  const Direction forward = Projection(camera, 1, 1).frame().forward;
  const Point back = camera.eye - 1.3 * size * forward;
  const ViewPose near{back + Vector(8 * size, -2 * size, 3 * size), back};
  const ViewProjection view(near, 800, 600);
  ASSERT_GT(glm::length(*view.pixelOf(camera.eye) - *view.pixelOf(back)), 3 * iconPixels);
  EXPECT_EQ(made.at(near, back).selection, (Selection{Part::eye}));
  EXPECT_NE(made.at(near, back + Vector(0, 0, 2 * size)).selection.part, Part::eye) << "above it";
  made.display.rtCamera = false;
  EXPECT_NE(made.at(near, back).selection.part, Part::eye);
}

TEST(Pick, TrianglesThatAreNotDrawnAreNotPicked) {
  Made made(Level{});
  const ViewPose front{{0, -14, 1}, {0, -3.4, 1}};
  ASSERT_EQ(made.at(front, Point(0, -3.4, 1)).selection.part, Part::sculpture);
  Sculpture unmapped = *made.sculpture.sculpture;
  for (PathStatus& status : unmapped.status) status = PathStatus::missesMirror;
  made.sculpture = prepareSculpture(std::move(unmapped));
  EXPECT_NE(made.at(front, Point(0, -3.4, 1)).selection.part, Part::sculpture);
}

TEST(Pick, FindsTheCellsOfThePixelGrid) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Level level;
    level.grid.columns = random.integer(1, 64);
    level.grid.rows = random.integer(1, 64);
    level.grid.distance = random.uniform(0.5, 2);
    level.camera.fovDegrees = random.uniform(20, 120);
    Made made(level);
    const GridCell cell{random.integer(0, level.grid.columns - 1), random.integer(0, level.grid.rows - 1)};
    const Projection grid(level.camera, level.grid.columns, level.grid.rows);
    const Ray ray = grid.rayThrough({cell.column + 0.5, cell.row + 0.5});
    const Point middle = ray.at(level.grid.distance / glm::dot(ray.direction, grid.frame().forward));
    const ViewPose pose{level.camera.eye + Vector(random.uniform(-3, 3), -8, 3), level.camera.target};
    EXPECT_FALSE(made.at(pose, middle).cell) << "not shown";
    made.display.rtCamera = true;
    const auto eye = ViewProjection(pose, 800, 600).pixelOf(level.camera.eye);
    const auto seen = ViewProjection(pose, 800, 600).pixelOf(middle);
    if (glm::length(*eye - *seen) < 2 * iconPixels) continue;
    const double size =
        rtCameraSize(level.grid, measureScene(boxOf(makeReflectionScene(level, made.sculpture))).radius);
    const auto body = intersectRtCamera(level.camera, size, {pose.eye, middle - pose.eye});
    if (body && *body < 1) continue;  // it is in front
    const Pick picked = made.at(pose, middle);
    ASSERT_TRUE(picked.cell);
    EXPECT_EQ(*picked.cell, cell);
    EXPECT_EQ(picked.selection, Selection{Part::eye});
    EXPECT_LT(glm::length(picked.where - middle), 1e-9);
  }
}

TEST(Pick, TheTopRowIsZero) {
  Level level;
  const Projection grid(level.camera, 8, 8);
  const auto hit =
      intersectGrid(level.camera, level.grid,
                    {level.camera.eye, glm::normalize(grid.frame().forward + 0.39 * grid.frame().up)});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->cell.row, 0);
}

TEST(Pick, IconsComeFirst) {
  Made made(Level{});
  const ViewPose pose{{10, -30, 20}, {0, -5, 4}};
  made.display.lightMarkers = true;
  EXPECT_EQ(made.at(pose, made.level.lights[1].position).selection, (Selection{Part::light, 1}));
  EXPECT_NE(made.at(pose, made.level.camera.eye).selection.part, Part::eye) << "not shown";
  made.display.rtCamera = true;
  const Pick eye = made.at(pose, made.level.camera.eye);
  EXPECT_EQ(eye.selection.part, Part::eye);
  EXPECT_FALSE(eye.cell);
  EXPECT_NEAR(eye.distance, glm::length(made.level.camera.eye - pose.eye), 1e-9);
  EXPECT_NE(made.at(pose, made.level.camera.target).selection.part, Part::aim)
      << "its camera is not selected";
  made.selection = {Part::eye};
  EXPECT_EQ(made.at(pose, made.level.camera.target).selection.part, Part::aim);
}

TEST(PickedPoint, NamesEveryVertex) {
  const Mesh mesh = makeBox({1, 2, 3}, 2);
  for (std::uint32_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    const auto picked = pickedVertex(mesh, vertex);
    ASSERT_TRUE(picked);
    EXPECT_EQ(pointOn(mesh, *picked), mesh.positions[vertex]);
  }
  EXPECT_FALSE(pickedVertex(mesh, 100000));
  EXPECT_FALSE(isOn(mesh, {100000, 0, 0}));
}

TEST(Pick, NothingThereAndAbsurdLevelsDoNoHarm) {
  DisplaySettings display;
  for (const Level& level : makeAbsurdLevels()) {
    for (const ViewPose& pose :
         {ViewPose{}, ViewPose{{0, 0, 0}, {0, 0, 0}}, ViewPose{level.camera.eye, {0, 0, 1}}}) {
      const ViewProjection projection(pose, 800, 600);
      for (const Pixel& pixel : {Pixel(400, 300), Pixel(0, 0), Pixel(1e9, -1e9)}) {
        const Pick picked = pick({projection, level, {}, {}, display, {Part::eye}}, pixel);
        EXPECT_FALSE(picked.point);
        EXPECT_TRUE(isFinite(picked.where));
      }
    }
  }
}

TEST(Pick, FindsAVertexThatIsJustMissed) {
  const Made made{Level{}};
  const Mesh& original = *made.original.mesh;
  const ViewPose pose{{12, -9, 7}, boundingBox(original.positions).centre()};
  const ViewProjection seen(pose, 800, 600);
  // The vertex that is seen farthest to the right is a corner of the outline.
  std::size_t corner = 0;
  for (std::size_t i = 0; i < original.positions.size(); ++i) {
    if (seen.pixelOf(original.positions[i])->x > seen.pixelOf(original.positions[corner])->x) corner = i;
  }
  const Pixel at = *seen.pixelOf(original.positions[corner]);
  const Pick beside = made.at(pose, at + Pixel(3, 0));
  ASSERT_TRUE(beside.point);
  EXPECT_EQ(beside.selection.part, Part::original);
  EXPECT_LT(glm::length(pointOn(original, *beside.point) - original.positions[corner]), 1e-9);
  EXPECT_FALSE(made.at(pose, at + Pixel(20, 0)).point);
}

}  // namespace
}  // namespace anamorph
