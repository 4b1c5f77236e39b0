#include "viewport/camera_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "edit/camera_body.h"
#include "random_scene.h"
#include "viewport/camera_model.h"
#include "viewport/scene_block.h"

namespace anamorph {
namespace {

using namespace testing;

TEST(CameraModel, IsMadeAnewOnlyForAnotherCamera) {
  CameraModel model;
  Camera camera;
  const PreparedMesh first = model.at(camera, 0.5);
  ASSERT_TRUE(first.mesh);
  EXPECT_EQ(model.at(camera, 0.5).mesh, first.mesh);
  camera.fovDegrees += 10;  // it looks the same
  EXPECT_EQ(model.at(camera, 0.5).mesh, first.mesh);
  EXPECT_EQ(model.count(), 1);
  camera.eye.x += 1;
  EXPECT_NE(model.at(camera, 0.5).mesh, first.mesh);
  model.at(camera, 0.6);
  EXPECT_EQ(model.count(), 3);
  camera.eye.x = std::nan("");
  EXPECT_FALSE(model.at(camera, 0.6).mesh);
}

TEST(CameraModel, IsInTheBodyThatIsPicked) {
  const PreparedMesh model = makeCameraModel(Point(0), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 1);
  const Box box = boundingBox(model.mesh->positions);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(box.min[axis], rtCameraBody.min[axis], 0.09);
    EXPECT_NEAR(box.max[axis], rtCameraBody.max[axis], 0.09);
    EXPECT_GE(box.min[axis], rtCameraBody.min[axis] - 1e-9);
    EXPECT_LE(box.max[axis], rtCameraBody.max[axis] + 1e-9);
  }
}

// While something is dragged the scene grows and shrinks a little in every frame.
TEST(CameraModel, FollowsTheScenesSizeInSteps) {
  PixelGrid grid;
  grid.distance = 100;
  std::set<double> sizes;
  for (int i = 0; i <= 200; ++i) {
    const double radius = 5 + 0.01 * i, size = rtCameraSize(grid, radius);
    EXPECT_NEAR(size, 0.05 * radius, 0.05 * 0.05 * radius);
    sizes.insert(size);
  }
  EXPECT_LE(sizes.size(), 5u);
  grid.distance = 0.1;
  EXPECT_EQ(rtCameraSize(grid, 7), 0.6 * 0.1);
}

Camera makeRandomCamera(Random& random) {
  Camera camera;
  camera.eye = random.point(20);
  camera.target = random.point(5);
  camera.up = random.direction();
  camera.fovDegrees = random.uniform(10, 120);
  return camera;
}

PixelGrid makeRandomGrid(Random& random) {
  PixelGrid grid;
  grid.columns = random.integer(1, 64);
  grid.rows = random.integer(1, 64);
  grid.distance = random.uniform(0.1, 5);
  return grid;
}

// Far from every camera here.
const Point elsewhere(1000, 0, 0);

TEST(CameraLines, AreTheGridAndTheFrustumOfTheProjection) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Camera camera = makeRandomCamera(random);
    const PixelGrid grid = makeRandomGrid(random);
    const int columns = grid.columns, rows = grid.rows;
    const Projection projection(camera, columns, rows);
    const auto lines = makeCameraLines(camera, grid, false, std::nullopt, elsewhere);
    ASSERT_EQ(lines.size(), std::size_t(columns + 1 + rows + 1 + 4));
    const auto expectAt = [&](const Point& point, double column, double row) {
      EXPECT_NEAR(glm::dot(point - camera.eye, projection.frame().forward), grid.distance, 1e-9);
      const auto pixel = projection.pixelOf(point);
      ASSERT_TRUE(pixel);
      EXPECT_NEAR(pixel->x, column, 1e-8);
      EXPECT_NEAR(pixel->y, row, 1e-8);
    };
    std::size_t next = 0;
    for (int i = 0; i <= columns; ++i, ++next) {
      expectAt(lines[next].from, i, 0);
      expectAt(lines[next].to, i, rows);
    }
    for (int j = 0; j <= rows; ++j, ++next) {
      expectAt(lines[next].from, 0, j);
      expectAt(lines[next].to, columns, j);
    }
    const Pixel corners[] = {Pixel(0, 0), Pixel(columns, 0), Pixel(columns, rows), Pixel(0, rows)};
    for (const Pixel& corner : corners) {
      EXPECT_EQ(lines[next].from, camera.eye);
      const Direction along = glm::normalize(lines[next].to - camera.eye);
      EXPECT_LT(glm::length(along - glm::normalize(projection.rayThrough(corner).direction)), 1e-9);
      expectAt(lines[next++].to, corner.x, corner.y);
    }
    for (const Line& line : lines) EXPECT_TRUE(line.width > 0 && line.alpha > 0 && !line.arrow);
  }
}

TEST(CameraLines, OutlineThePickedCell) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Camera camera = makeRandomCamera(random);
    const PixelGrid grid = makeRandomGrid(random);
    const GridCell cell{random.integer(0, grid.columns - 1), random.integer(0, grid.rows - 1)};
    const auto without = makeCameraLines(camera, grid, false, std::nullopt, elsewhere);
    const auto lines = makeCameraLines(camera, grid, false, cell, elsewhere);
    ASSERT_EQ(lines.size(), without.size() + 4);
    EXPECT_TRUE(std::equal(without.begin(), without.end(), lines.begin()));
    Point middle(0);
    for (std::size_t i = without.size(); i < lines.size(); ++i) {
      EXPECT_NE(lines[i].color, without[0].color);
      EXPECT_GT(lines[i].width, without[0].width);
      EXPECT_EQ(lines[i].to, lines[i + 1 < lines.size() ? i + 1 : without.size()].from) << "closed";
      middle += 0.25 * lines[i].from;
    }
    const auto hit = intersectGrid(camera, grid, {camera.eye, middle - camera.eye});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->cell, cell) << "it is the cell that would be picked there";
  }
}

TEST(CameraLines, SelectedOnesHaveAnotherColour) {
  const Camera camera;
  const PixelGrid grid;
  const auto plain = makeCameraLines(camera, grid, false, std::nullopt, elsewhere);
  const auto selected = makeCameraLines(camera, grid, true, std::nullopt, elsewhere);
  ASSERT_EQ(plain.size(), selected.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_NE(plain[i].color, selected[i].color);
    EXPECT_EQ(plain[i].to, selected[i].to);
  }
}

TEST(CameraLines, AreNotInTheWayOfTheRtCamerasOwnView) {
  const Camera camera;
  const PixelGrid grid;
  EXPECT_TRUE(makeCameraLines(camera, grid, true, GridCell{}, camera.eye).empty());
  EXPECT_TRUE(makeCameraLines(camera, grid, true, GridCell{}, camera.eye + Vector(0.1, 0.2, 0.1)).empty());
  EXPECT_FALSE(makeCameraLines(camera, grid, true, GridCell{}, camera.eye - Vector(0, 1, 0)).empty());
}

TEST(CameraLines, StayFiniteForAnyCamera) {
  Camera atTarget;
  atTarget.target = atTarget.eye;
  Camera alongUp;
  alongUp.up = alongUp.target - alongUp.eye;
  Camera wide;
  wide.fovDegrees = 170;
  PixelGrid grid;
  grid.columns = 64;
  grid.rows = 1;
  for (const Camera& camera : {atTarget, alongUp, wide}) {
    for (const Line& line : makeCameraLines(camera, grid, true, GridCell{}, elsewhere)) {
      EXPECT_TRUE(isFinite(line.from) && isFinite(line.to));
    }
  }
}

}  // namespace
}  // namespace anamorph
