// The exact sculptures of the thesis' scenes and of other mirrors, against vertices computed by an implementation that shares no
// code with this one (data/expected, 17 digits, in vertex order).

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "geometry/mesh_files.h"
#include "level/level_json.h"
#include "pipeline/mirror_files.h"
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

// The thesis' scenes name no mesh; others are levels.
std::string fileOf(const std::string& scene) {
  const std::string file = data + "/scenes/" + scene + ".json";
  return std::filesystem::exists(file) ? file : data + "/levels/" + scene + ".json";
}

class Expected : public ::testing::TestWithParam<Case> {};

TEST_P(Expected, VerticesAreRightToTwelveDigits) {
  const auto [scene, model] = GetParam();
  LoadedLevel loaded = loadLevel(fileOf(scene));
  readMirrorFiles(loaded.level, fileOf(scene));
  const Mesh mesh = loadMesh(data + "/meshes/" + model + ".obj").mesh;
  DeformInput input =
      makeDeformInput(loaded.level, placeOriginal(mesh, false, loaded.level.original.placement));
  input.tolerancePixels = 0;
  const Sculpture sculpture = makeSculpture(input);
  ASSERT_EQ(sculpture.mesh.positions.size(), mesh.positions.size());
  EXPECT_EQ(sculpture.mesh.triangles.size(), mesh.triangles.size());
  if (isClosed(mesh)) {
    EXPECT_GT(signedVolume(sculpture.mesh), 0) << "turned inside out";
  }

  std::ifstream file(data + "/expected/" + scene + "-" + model + ".txt");
  ASSERT_TRUE(file);
  const double size = boundingBox(sculpture.mesh.positions).diagonal();
  double worst = 0;
  Point expected;
  std::size_t i = 0;
  for (; file >> expected.x >> expected.y >> expected.z; ++i) {
    ASSERT_LT(i, sculpture.mesh.positions.size());
    worst = std::max(worst, glm::length(sculpture.mesh.positions[i] - expected) / size);
  }
  EXPECT_EQ(i, mesh.positions.size());
  EXPECT_LT(worst, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    All, Expected,
    ::testing::Values(Case{"framework-cylinder-1", "box"}, Case{"framework-cylinder-1", "cube"},
                      Case{"framework-cylinder-2", "box"}, Case{"framework-cylinder-2", "cube"},
                      Case{"framework-plane-1", "box"}, Case{"framework-plane-1", "cube"},
                      Case{"framework-plane-2", "box"}, Case{"framework-plane-2", "cube"},
                      Case{"framework-sphere-1", "box"}, Case{"framework-sphere-1", "cube"},
                      Case{"framework-sphere-2", "box"}, Case{"framework-sphere-2", "cube"},
                      Case{"thesis-flat", "box"}, Case{"thesis-flat", "cube"}, Case{"thesis-sphere", "box"},
                      Case{"thesis-sphere", "cube"}, Case{"cone", "box"}, Case{"cone", "cube"},
                      Case{"cone", "points"}, Case{"mesh", "cube"}, Case{"mesh", "points"}),
    [](const auto& each) {
      std::string name = std::string(each.param.scene) + "_" + each.param.model;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

TEST(ExpectedProblem, ThesisCylinderIsExplained) {
  const LoadedLevel loaded = loadLevel(data + "/scenes/thesis-cylinder.json");
  const Mesh mesh = loadMesh(data + "/meshes/box.obj").mesh;
  const auto original = placeOriginal(mesh, false, loaded.level.original.placement);
  EXPECT_EQ(findProblem(loaded.level, boundingBox(original->positions)),
            "the eye is inside the cylinder (continued beyond its ends): it is 5 from the axis and the "
            "radius is 10. "
            "From there no ray meets the outside of the mirror. Move the eye away from the axis, or make the "
            "radius "
            "smaller.");
}

}  // namespace
}  // namespace anamorph
