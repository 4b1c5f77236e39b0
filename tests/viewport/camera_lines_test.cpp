#include "viewport/camera_lines.h"

#include <gtest/gtest.h>

#include <string>

#include "random_scene.h"

namespace anamorph {
namespace {

using namespace testing;

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
