#include "edit/model_turns.h"

#include <algorithm>
#include <array>
#include <string>

#include <gtest/gtest.h>

#include "cli/program.h"
#include "edit/edit_levels.h"
#include "geometry/shapes.h"
#include "pipeline/original.h"

namespace anamorph {
namespace {

using namespace testing;

Mesh placedMesh(const Level& level) {
  const auto mesh = loadOriginal(level.original.shape, {}).mesh;
  return *placeOriginal(*mesh, level.original.unitize, level.original.placement);
}

double farthest(const Mesh& a, const Mesh& b) {
  double distance = 0;
  for (std::size_t i = 0; i < a.positions.size(); ++i)
    distance = std::max(distance, glm::length(a.positions[i] - b.positions[i]));
  return distance;
}

// A level with a mesh file that is far from its own origin.
class ModelTurns : public ::testing::Test {
 protected:
  ModelTurns() {
    writeText(folder_ / "box.obj",
              "v 100 0 7\nv 106 0 7\nv 106 3 7\nv 100 3 7\nv 100 0 8\nv 106 0 8\nv 106 3 8\nv 100 3 8\n"
              "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    level_.original.shape = FileShape{folder_ / "box.obj"};
    level_.original.placement = {{-100, 5, -6}, {0, 0, 0}, Vector(1)};
  }
  TemporaryFolder folder_;
  Level level_;
};

TEST_F(ModelTurns, AQuarterTurnStandsWhereItStood) {
  const Box box = boundingBox(placedMesh(level_).positions);
  const std::array<Vector, 3> sizes{Vector(6, 1, 3), Vector(1, 3, 6), Vector(3, 6, 1)};
  for (int axis = 0; axis < 3; ++axis) {
    SCOPED_TRACE(axis);
    const Box turned = boundingBox(placedMesh(turnedQuarter(level_, axis, placedMesh(level_))).positions);
    EXPECT_LT(glm::length(turned.size() - sizes.at(static_cast<std::size_t>(axis))), 1e-9);
    EXPECT_NEAR(turned.min.z, box.min.z, 1e-9);
    EXPECT_NEAR(turned.centre().x, box.centre().x, 1e-9);
    EXPECT_NEAR(turned.centre().y, box.centre().y, 1e-9);
  }
}

TEST_F(ModelTurns, FourQuarterTurnsAreNone) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Level level = makeRandomLevel(ShapeKind::plane, random);
    const Mesh before = placedMesh(level);
    const double size = boundingBox(before.positions).diagonal();
    for (int i = 0; i < 4; ++i) level = turnedQuarter(level, static_cast<int>(seed % 3), placedMesh(level));
    const Mesh after = placedMesh(level);
    EXPECT_LT(farthest(before, after), 1e-6 * size);
  }
}

TEST_F(ModelTurns, StandingUpTurnsTheMeshAndGoesRoundInFour) {
  const Mesh lying = placedMesh(level_);
  const Box box = boundingBox(lying.positions);
  Level level = level_;
  for (const Vector& size : {Vector(6, 1, 3), Vector(6, 1, 3), Vector(1, 3, 6), Vector(6, 3, 1)}) {
    level = withModelUp(level, nextModelUp(std::get<FileShape>(level.original.shape).up), placedMesh(level));
    const Box now = boundingBox(placedMesh(level).positions);
    EXPECT_LT(glm::length(now.size() - size), 1e-9);
    EXPECT_NEAR(now.min.z, box.min.z, 1e-9) << "it stands where it stood";
    EXPECT_NEAR(now.centre().x, box.centre().x, 1e-9);
  }
  EXPECT_LT(farthest(placedMesh(level), lying), 1e-9);
  EXPECT_EQ(withModelUp(Level{}, ModelUp::y, lying), Level{}) << "built-in shapes stand";
}

TEST_F(ModelTurns, StandingUpKeepsRotationScaleAndUnitizing) {
  level_.original.unitize = true;
  level_.original.placement = {{1, 2, 3}, {0, 0, 30}, Vector(2)};
  const Box box = boundingBox(placedMesh(level_).positions);
  const Level up = withModelUp(level_, ModelUp::y, placedMesh(level_));
  EXPECT_EQ(up.original.placement.rotationDegrees, level_.original.placement.rotationDegrees);
  EXPECT_EQ(up.original.placement.scale, level_.original.placement.scale);
  EXPECT_NEAR(boundingBox(placedMesh(up).positions).min.z, box.min.z, 1e-9);
  EXPECT_NEAR(boundingBox(placedMesh(up).positions).size().z, 1, 1e-9);
}

}  // namespace
}  // namespace anamorph
