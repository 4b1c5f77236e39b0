// The map of whole levels against points and statuses that were computed with 34 digits by an implementation which
// shares no code with this one (data/expected: in vertex order, 17 digits, or what became of the vertex).

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "geometry/mesh_files.h"
#include "level/level_json.h"
#include "pipeline/original.h"
#include "pipeline/stages.h"

namespace anamorph {
namespace {

const std::string data = ANAMORPH_TEST_DATA;

struct Case {
  const char* scene;
  const char* model;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.scene << " " << c.model;
}

class ExpectedPoints : public ::testing::TestWithParam<Case> {};

TEST_P(ExpectedPoints, AreRightToTwelveDigitsAndStatusesAreEqual) {
  const auto [scene, model] = GetParam();
  const Level level = loadLevel(data + "/levels/" + scene + ".json").level;
  const Mesh mesh = loadMesh(data + "/meshes/" + model + ".obj").mesh;
  const auto original = placeOriginal(mesh, false, level.original.placement);
  const VertexMap map = makeDeformInput(level, original).map;
  std::ifstream file(data + "/expected/" + scene + "-" + model + ".txt");
  ASSERT_TRUE(file);

  double largest = 0, worst = 0;
  std::size_t i = 0;
  for (std::string line; std::getline(file, line); ++i) {
    ASSERT_LT(i, original->positions.size());
    const MappedPoint mapped = mapPoint(map, original->positions[i]);
    std::istringstream numbers(line);
    Point expected;
    if (!(numbers >> expected.x >> expected.y >> expected.z)) {
      EXPECT_EQ(pathStatusName(mapped.status), line) << "vertex " << i;
      continue;
    }
    ASSERT_EQ(mapped.status, PathStatus::mapped) << "vertex " << i;
    const Vector off = glm::abs(mapped.point - expected);
    worst = std::max({worst, off.x, off.y, off.z});
    largest = std::max({largest, std::abs(expected.x), std::abs(expected.y), std::abs(expected.z)});
  }
  EXPECT_EQ(i, original->positions.size());
  EXPECT_LT(worst / largest, 1e-12);
  RecordProperty("worst", std::to_string(worst / largest * 1e15) + "e-15");
}

INSTANTIATE_TEST_SUITE_P(All, ExpectedPoints,
                         ::testing::Values(Case{"vase", "cube"}, Case{"vase", "points"},
                                           Case{"wavy-wall", "cube"}, Case{"wavy-wall", "points"},
                                           Case{"patch", "box"}, Case{"patch", "cube"},
                                           Case{"patch", "points"}),
                         [](const auto& each) {
                           std::string name = std::string(each.param.scene) + "_" + each.param.model;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace anamorph
