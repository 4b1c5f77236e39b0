// The exact sculptures of the thesis' scenes and of other mirrors, against vertices computed by an implementation that shares no
// code with this one (data/expected, 17 digits, in vertex order).

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

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
  bool folds = false;  ///< the mirror turns a part of it around
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.scene << " " << c.model;
}

// The thesis' scenes name no mesh; others are levels.
std::string fileOf(const std::string& scene) {
  const std::string file = data + "/scenes/" + scene + ".json";
  return std::filesystem::exists(file) ? file : data + "/levels/" + scene + ".json";
}

// A line of the file: a place, or the word for what became of the vertex.
struct Vertex {
  Point place{0};
  std::string status = pathStatusName(PathStatus::mapped);
};

std::vector<Vertex> readExpected(const std::string& path) {
  std::ifstream file(path);
  std::vector<Vertex> vertices;
  for (std::string line; std::getline(file, line);) {
    Vertex vertex;
    std::istringstream numbers(line);
    if (!(numbers >> vertex.place.x >> vertex.place.y >> vertex.place.z)) vertex.status = line;
    vertices.push_back(vertex);
  }
  return vertices;
}

class Expected : public ::testing::TestWithParam<Case> {};

TEST_P(Expected, VerticesAreRightToTwelveDigits) {
  const auto [scene, model, folds] = GetParam();
  LoadedLevel loaded = loadLevel(fileOf(scene));
  readMirrorFiles(loaded.level, fileOf(scene));
  const Mesh mesh = loadMesh(data + "/meshes/" + model + ".obj").mesh;
  DeformInput input =
      makeDeformInput(loaded.level, placeOriginal(mesh, false, loaded.level.original.placement));
  input.tolerancePixels = 0;
  const Sculpture sculpture = makeSculpture(input);
  const std::vector<Vertex> expected = readExpected(data + "/expected/" + scene + "-" + model + ".txt");
  ASSERT_EQ(sculpture.mesh.positions.size(), mesh.positions.size());
  ASSERT_EQ(expected.size(), mesh.positions.size());
  double largest = 0, worst = 0;
  bool whole = true;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(pathStatusName(sculpture.status[i]), expected[i].status) << i;
    whole &= sculpture.status[i] == PathStatus::mapped;
    if (sculpture.status[i] != PathStatus::mapped) continue;
    const Vector size = glm::abs(expected[i].place);
    largest = std::max({largest, size.x, size.y, size.z});
    worst = std::max(worst, glm::length(sculpture.mesh.positions[i] - expected[i].place));
  }
  EXPECT_LT(worst, 1e-12 * largest);
  if (!whole || folds) return;
  EXPECT_EQ(sculpture.mesh.triangles.size(), mesh.triangles.size());
  if (isClosed(mesh)) {
    EXPECT_GT(signedVolume(sculpture.mesh), 0) << "turned inside out";
  }
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
                      Case{"cone", "points"}, Case{"dish", "cube", true}, Case{"dish", "points", true},
                      Case{"floor-mirror", "cube"}, Case{"floor-mirror", "points"},
                      Case{"paraboloid", "cube"}, Case{"paraboloid", "points"}, Case{"mesh", "cube"},
                      Case{"mesh", "points"}, Case{"vase", "cube"}, Case{"vase", "points"},
                      Case{"wavy-wall", "cube"}, Case{"wavy-wall", "points"}, Case{"patch", "box"},
                      Case{"patch", "cube"}, Case{"patch", "points"}),
    [](const auto& each) {
      std::string name = std::string(each.param.scene) + "_" + each.param.model;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

}  // namespace
}  // namespace anamorph
