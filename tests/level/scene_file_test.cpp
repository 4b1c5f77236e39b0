#include "level/scene_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "error_text.h"
#include "level/level_json.h"
#include "shapes.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

struct Published {
  const char* name;
  Point eye;
  Shape mirror;
  Point mesh;
};

void PrintTo(const Published& scene, std::ostream* out) {
  *out << scene.name;
}

class PublishedScenes : public testing::TestWithParam<Published> {};

TEST_P(PublishedScenes, LoadAsTheyAre) {
  const Published& scene = GetParam();
  const LoadedLevel loaded =
      loadLevel(fs::path(ANAMORPH_TEST_DATA) / "scenes" / (std::string(scene.name) + ".json"));
  EXPECT_TRUE(loaded.isThesisScene);
  EXPECT_TRUE(loaded.warnings.empty());
  const Level& level = loaded.level;
  EXPECT_EQ(level.camera.eye, scene.eye);
  EXPECT_EQ(level.camera.target, scene.mesh);
  EXPECT_EQ(level.camera.up, Vector(0, 0, 1));
  EXPECT_EQ(level.camera.fovDegrees, 40);
  EXPECT_TRUE(level.optic.shape() == scene.mirror);
  EXPECT_TRUE(level.original.shape == OriginalShape{FileShape{}});
  EXPECT_EQ(level.original.placement, Placement{.position = scene.mesh});
  EXPECT_FALSE(level.original.unitize);
  EXPECT_EQ(level.sculpture.depthScale, 1);
}

PlaneMirror upright(double x0, double x1, double y, double z0, double z1) {
  return {{Point(x0, y, z1), Point(x1, y, z1), Point(x1, y, z0), Point(x0, y, z0)}};
}

// Typed from the published files, not read from them.
INSTANTIATE_TEST_SUITE_P(
    , PublishedScenes,
    testing::Values(
        Published{"thesis-flat", {2, -12, 8}, upright(15, -15, 0, 0, 10), {2, 10, 1}},
        Published{"thesis-cylinder", {0, -30, 15}, CylinderMirror{{0, 0, 10}, {0, 40, 10}, 10}, {0, 30, 1}},
        Published{"thesis-sphere", {0, -12, 5}, SphereMirror{{0, 0, 5}, 5}, {0, 5, 1}},
        Published{"framework-plane-1",
                  {0, 1.137, -6.648},
                  PlaneMirror{{Point(-10, 6.6417, 0.452), Point(10, 6.6417, 0.452), Point(10, -3.583, 0.452),
                               Point(-10, -3.583, 0.452)}},
                  {0, -0.15, 3.01}},
        Published{"framework-plane-2", {0, -12, 5}, upright(-10, 10, 0, 0, 10), {0, 3, 1}},
        Published{"framework-cylinder-1",
                  {0, 1.137, -6.648},
                  CylinderMirror{{0, 0.4, 0}, {0, 3.4, 0}, 4},
                  {0, -0.15, 3.01}},
        Published{"framework-cylinder-2", {0, -10, 4}, CylinderMirror{{0, 0, 0}, {0, 0, 6}, 4}, {0, 7, 1}},
        Published{"framework-sphere-1", {0, 1.137, -6.648}, SphereMirror{{0, 1.9, 0}, 4}, {0, -0.15, 3.01}},
        Published{"framework-sphere-2", {0, -12, 4}, SphereMirror{{0, 0, 4}, 4}, {0, 7, 4}}),
    [](const auto& published) {
      std::string name = published.param.name;
      for (char& c : name) {
        if (c == '-') c = '_';
      }
      return name;
    });

const char* const sphere = R"({"type": "sphere", "position": [0, 0, 4], "radius": 4})";
const char* const mesh = R"({"type": "mesh", "position": [0, 7, 4]})";

std::string sceneOf(const std::string& objects, const std::string& eye = "[0, -12, 4]") {
  return "{\"Eye\": " + eye + ", \"Objects\": [" + objects + "]}";
}

std::string complaintOf(const std::string& text) {
  return withoutPlaces(errorOf([&] { parseLevel(text, "s.json"); }));
}

std::string both(const std::string& first, const std::string& second) {
  return first + ", " + second;
}

TEST(SceneFile, RefusesOtherNumbersOfMirrorsAndMeshes) {
  const std::string expected =
      "s.json: /Objects: expected one mirror (quad, cylinder or sphere) and one mesh, got ";
  EXPECT_EQ(complaintOf(sceneOf(both(sphere, mesh))), "no error");
  EXPECT_EQ(complaintOf(sceneOf(both(mesh, sphere))), "no error");
  EXPECT_EQ(complaintOf(sceneOf("")), expected + "0 and 0");
  EXPECT_EQ(complaintOf(sceneOf(sphere)), expected + "1 and 0");
  EXPECT_EQ(complaintOf(sceneOf(mesh)), expected + "0 and 1");
  EXPECT_EQ(complaintOf(sceneOf(both(both(sphere, sphere), mesh))), expected + "2 and 1");
  EXPECT_EQ(complaintOf(sceneOf(both(both(sphere, mesh), mesh))), expected + "1 and 2");
}

TEST(SceneFile, IsAsStrictAsALevel) {
  EXPECT_EQ(complaintOf(R"({"Objects": []})"), "s.json: expected the key \"Eye\", got an object without it");
  EXPECT_EQ(complaintOf(R"({"Eye": [0, 0, 0]})"),
            "s.json: expected the key \"Objects\", got an object without it");
  EXPECT_EQ(complaintOf(R"({"Eye": [0, 0, 0], "Objects": {}})"),
            "s.json: /Objects: expected an array, got an object");
  EXPECT_EQ(complaintOf(sceneOf(both(sphere, mesh), "[0, -12]")),
            "s.json: /Eye: expected an array of 3 numbers, got [0, -12]");
  EXPECT_EQ(complaintOf(sceneOf(both(sphere, mesh), "[0, -12, 1e7]")),
            "s.json: /Eye/2: expected a number from -1000000 to 1000000, got 1e7");
  EXPECT_EQ(complaintOf(sceneOf(R"({"type": "cone"})")),
            "s.json: /Objects/0/type: expected \"quad\", \"cylinder\", \"sphere\" or \"mesh\", got \"cone\"");
  EXPECT_EQ(complaintOf(sceneOf(both(mesh, R"({"type": "sphere", "position": [0, 0, 4], "radius": -4})"))),
            "s.json: /Objects/1/radius: expected a number from 0.000001 to 1000000, got -4");
  EXPECT_EQ(complaintOf(sceneOf(both(mesh, R"({"type": "cylinder", "topPoint": [0, 0, 4], "radius": 4})"))),
            "s.json: /Objects/1: expected the key \"bottomPoint\", got an object without it");
  EXPECT_EQ(complaintOf(sceneOf(
                both(mesh, R"({"type": "quad", "v0": [0, 0, 4], "v1": [0, 1, 4], "v2": [1, 1, 4]})"))),
            "s.json: /Objects/1: expected the key \"v3\", got an object without it");
  EXPECT_EQ(complaintOf(sceneOf(both(sphere, R"({"type": "mesh"})"))),
            "s.json: /Objects/1: expected the key \"position\", got an object without it");
}

TEST(SceneFile, UnknownKeysWarnAndAreNotKept) {
  const LoadedLevel loaded =
      parseLevel(sceneOf(both(sphere, R"({"type": "mesh", "position": [0, 7, 4], "color": 1})")), "s.json");
  ASSERT_EQ(loaded.warnings.size(), 1u);
  EXPECT_EQ(withoutPlaces(loaded.warnings[0]), "s.json: /Objects/1/color: unknown key, ignored");
  EXPECT_TRUE(loaded.level.text->unknownKeys.empty());
}

TEST(SceneFile, WithAModelItCanBeSavedAsALevel) {
  Level level = parseLevel(sceneOf(both(sphere, mesh)), "s.json").level;
  level.original.shape = FileShape{"box.obj"};
  const LoadedLevel again = parseLevel(formatLevel(level), "l.json");
  EXPECT_FALSE(again.isThesisScene);
  EXPECT_TRUE(again.level == level);
}

}  // namespace
}  // namespace anamorph
