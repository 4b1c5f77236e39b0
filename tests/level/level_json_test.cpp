#include "level/level_json.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "base/file.h"
#include "error_text.h"
#include "level/level_fields.h"
#include "level/random_level.h"
#include "optics/shape_table.h"
#include "shapes.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& path) {
  return std::string(readFile(path, maxLevelBytes).view());
}

fs::path scratch(const std::string& name) {
  return fs::path(testing::TempDir()) / (std::to_string(getpid()) + name);
}

const std::string& baseText() {
  static const std::string text = textOf(fs::path(ANAMORPH_TEST_DATA) / "levels" / "every-field.json");
  return text;
}

// The base level with one piece of its text replaced; the piece must be there, or the case would test
// nothing.
std::string baseWith(const std::string& from, const std::string& to) {
  std::string text = baseText();
  const std::size_t place = text.find(from);
  if (place == std::string::npos) throw Error("not in the base level: " + from);
  return text.replace(place, from.size(), to);
}

std::string complaintOf(const std::string& text) {
  return withoutPlaces(errorOf([&] { parseLevel(text, "l.json"); }));
}

TEST(LevelJson, RandomLevelsSurviveFormatAndParse) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Level level = RandomLevel(seed).make();
    const std::string text = formatLevel(level);
    const LoadedLevel loaded = parseLevel(text, "random.json");
    ASSERT_TRUE(loaded.level == level) << "seed " << seed << "\n" << text;
    ASSERT_EQ(formatLevel(loaded.level), text) << "seed " << seed;
    ASSERT_EQ(loaded.warnings.size(), level.text->unknownKeys.size());
  }
}

TEST(LevelJson, FormatIsStable) {
  const LoadedLevel loaded = parseLevel(baseText(), "l.json");
  EXPECT_EQ(formatLevel(loaded.level), baseText());
  EXPECT_TRUE(loaded.warnings.empty());
  EXPECT_FALSE(loaded.isThesisScene);
}

TEST(LevelJson, ReadsEveryField) {
  Level expected;
  expected.optic.shape() = CylinderMirror{{1, 2, 3}, {4, 5, 6}, 7};
  expected.mirrorLook = {Color(0.1, 0.2, 0.3), 0.4};
  expected.camera = {Point(1, -12, 8), Point(2, 4, 6), Vector(0, 1, 0), 33};
  expected.grid = {9, 7, 1.5};
  expected.original = {TorusKnotShape{3, 4, 0.2, 100, 10},
                       true,
                       {Point(7, 8, 9), Vector(10, 20, 30), Vector(1, 2, 3)},
                       {Color(0.5, 0.6, 0.7), 0.11, 0.12, 0.13, 14}};
  expected.sculpture = {
      0.5, 3.5, 0, 1000, 256, {true, false, true}, {Color(0.8, 0.9, 1), 0.21, 0.22, 0.23, 24}, std::nullopt};
  expected.lights = {{Point(1, 1, 1), Color(0.3, 0.2, 0.1), 0.9}};
  expected.background = {Color(0.1, 0.1, 0.1), Color(0.2, 0.2, 0.2)};
  expected.ground = {false, -1};
  expected.tracing = {5, false, 4};
  expected.view = {Point(9, 8, 7), Point(6, 5, 4), 50};
  const char* const lesson =
      R"({"id": "every", "steps": [{"id": "eye", "title": "Aside", "why": "To see.", "do": "Move the eye", "done": [{"when": "movedEye"}]}]})";
  expected.text = LevelText{"Every field", "Two\nlines", lesson, {}, "level.schema.json"};
  EXPECT_TRUE(parseLevel(baseText(), "l.json").level == expected);
}

TEST(LevelJson, WhatIsNotSaidIsTheDefault) {
  const std::string text = R"({"format": "anamorph-level", "version": 1,
    "optic": {"kind": "mirror", "shape": {"type": "plane", "corners": [[-8,0,0], [8,0,0], [8,0,8], [-8,0,8]]}},
    "camera": {"eye": [0, -11.9, 6.5], "target": [0, 3.4, 1]}, "original": {"shape": {"type": "box"}}})";
  EXPECT_TRUE(parseLevel(text, "l.json").level == Level{});
}

TEST(LevelJson, TheAxisThatPointsUpIsWrittenOnlyWhenItIsNotZ) {
  Level level;
  for (const ModelUp up : {ModelUp::z, ModelUp::y, ModelUp::minusY, ModelUp::x}) {
    level.original.shape = FileShape{.path = "a.obj", .up = up};
    const std::string text = formatLevel(level);
    EXPECT_EQ(text.find("\"up\": \"" + std::string(modelUpName(up)) + "\"") != std::string::npos,
              up != ModelUp::z)
        << text;
    EXPECT_TRUE(parseLevel(text, "l.json").level == level) << text;
  }
}

TEST(LevelJson, AcceptsBothFormsOfScaleAndTolerance) {
  const auto read = [](const std::string& from, const std::string& to) {
    return parseLevel(baseWith(from, to), "l.json").level;
  };
  EXPECT_EQ(read("\"scale\": [1, 2, 3]", "\"scale\": 0.7").original.placement.scale, Vector(0.7));
  EXPECT_EQ(read("\"off\"", "0").sculpture.tolerancePixels, 0);
  EXPECT_EQ(read("\"off\"", "0.5").sculpture.tolerancePixels, 0.5);
  EXPECT_EQ(read("\"segments\": 100", "\"segments\": 1e2").original.shape,
            parseLevel(baseText(), "l.json").level.original.shape);
}

TEST(LevelJson, UnknownKeysWarnAndSurvive) {
  const std::string text = baseWith("\"radius\": 7", "\"radius\": 7, \"glow/\": {\"power\": [1.50, \"x\"]}");
  std::string twice = text;
  twice.insert(twice.find("\"title\""), "\"author\": \"A. N.\",\n  ");
  const LoadedLevel loaded = parseLevel(twice, "l.json");
  EXPECT_EQ(loaded.warnings,
            (std::vector<std::string>{
                "l.json: line 5, column 3: /author: unknown key, kept but not used",
                "l.json: line 10, column 87: /optic/shape/glow~1: unknown key, kept but not used"}));
  const std::string saved = formatLevel(loaded.level);
  EXPECT_NE(saved.find("\"radius\": 7,\n      \"glow/\": {\"power\": [1.50, \"x\"]}"), std::string::npos)
      << saved;
  EXPECT_NE(saved.find(",\n  \"author\": \"A. N.\"\n}"), std::string::npos) << saved;
  EXPECT_TRUE(parseLevel(saved, "l.json").level == loaded.level);
}

TEST(LevelJson, AKeyThatBecameKnownIsWrittenOnce) {
  Level level;
  level.text.edit([&](LevelText& text) { text.unknownKeys = {{"/optic/shape", "radius", "5"}}; });
  level.optic.shape() = SphereMirror{{0, 0, 4}, 4};
  const LoadedLevel loaded = parseLevel(formatLevel(level), "l.json");
  EXPECT_EQ(loaded.level.optic.shape(), level.optic.shape());
  EXPECT_TRUE(loaded.warnings.empty());
}

struct BadLevel {
  const char* name;
  const char* from;
  const char* to;
  const char* message;  // after "l.json: "
};

void PrintTo(const BadLevel& bad, std::ostream* out) {
  *out << bad.name;
}

class BadLevels : public testing::TestWithParam<BadLevel> {};

TEST_P(BadLevels, AreRefusedWithTheirJsonPointer) {
  const BadLevel& bad = GetParam();
  EXPECT_EQ(complaintOf(baseWith(bad.from, bad.to)), std::string("l.json: ") + bad.message);
}

INSTANTIATE_TEST_SUITE_P(
    , BadLevels,
    testing::Values(
        BadLevel{"OtherFormat", "anamorph-level", "gltf",
                 "/format: expected \"anamorph-level\", got \"gltf\""},
        BadLevel{"FormatIsNumber", "\"anamorph-level\"", "1", "/format: expected \"anamorph-level\", got 1"},
        BadLevel{"NoFormat", "\"format\": \"anamorph-level\",", "",
                 "expected a level (with \"format\": \"anamorph-level\") or a scene of the thesis (with "
                 "\"Eye\" and "
                 "\"Objects\"), got neither"},
        BadLevel{"NoVersion", "\"version\": 2,", "",
                 "expected the key \"version\", got an object without it"},
        BadLevel{
            "NewerVersion", "\"version\": 2", "\"version\": 3",
            "/version: expected at most 2 (this level was made by a newer Anamorph, please update), got 3"},
        BadLevel{"VersionIsZero", "\"version\": 2", "\"version\": 0",
                 "/version: expected a whole number from 1 to 1000000, got 0"},
        BadLevel{"VersionIsText", "\"version\": 2", "\"version\": \"1\"",
                 "/version: expected a whole number from 1 to 1000000, got \"1\""},
        BadLevel{"TitleIsNumber", "\"Every field\"", "7", "/title: expected a string, got 7"},
        BadLevel{"NoOptic", "\"optic\"", "\"optics\"",
                 "expected the key \"optic\", got an object without it"},
        BadLevel{"NoCamera", "\"camera\"", "\"kamera\"",
                 "expected the key \"camera\", got an object without it"},
        BadLevel{"NoOriginal", "\"original\"", "\"Original\"",
                 "expected the key \"original\", got an object without it"},
        BadLevel{"UnknownOptic", "\"mirror\"", "\"glass\"",
                 "/optic/kind: expected \"mirror\" or \"none\", got \"glass\""},
        BadLevel{"NoOpticKind", "\"kind\"", "\"sort\"",
                 "/optic: expected the key \"kind\", got an object without it"},
        BadLevel{"UnknownMirror", "\"type\": \"cylinder\"", "\"type\": \"egg\"",
                 "/optic/shape/type: expected \"plane\", \"cylinder\", \"sphere\", \"cone\", \"ellipsoid\", "
                 "\"paraboloid\", \"revolution\", \"extrusion\", \"patch\" or \"mesh\", got \"egg\""},
        BadLevel{"NoMirrorType", "\"type\": \"cylinder\", ", "",
                 "/optic/shape: expected the key \"type\", got an object without it"},
        BadLevel{"MirrorOfOtherType", "\"type\": \"cylinder\"", "\"type\": \"sphere\"",
                 "/optic/shape: expected the key \"centre\", got an object without it"},
        BadLevel{
            "ThreeCorners", "\"type\": \"cylinder\"",
            "\"type\": \"plane\", \"corners\": [[0,0,0],[1,0,0],[1,0,1]]",
            "/optic/shape/corners: expected an array of 4 points, got [[0, 0, 0], [1, 0, 0], [1, 0, 1]]"},
        BadLevel{"CornerIsNumber", "\"type\": \"cylinder\"",
                 "\"type\": \"plane\", \"corners\": [[0,0,0],[1,0,0],2,3]",
                 "/optic/shape/corners/2: expected an array of 3 numbers, got 2 (and 1 more)"},
        BadLevel{"NegativeRadius", "\"radius\": 7", "\"radius\": -4",
                 "/optic/shape/radius: expected a number from 0.000001 to 1000000, got -4"},
        BadLevel{"ZeroRadius", "\"radius\": 7", "\"radius\": 0",
                 "/optic/shape/radius: expected a number from 0.000001 to 1000000, got 0"},
        BadLevel{"TinyRadius", "\"radius\": 7", "\"radius\": 1e-300",
                 "/optic/shape/radius: expected a number from 0.000001 to 1000000, got 1e-300"},
        BadLevel{"HugeRadius", "\"radius\": 7", "\"radius\": 1e300",
                 "/optic/shape/radius: expected a number from 0.000001 to 1000000, got 1e300"},
        BadLevel{"InfiniteRadius", "\"radius\": 7", "\"radius\": 1e999",
                 "/optic/shape/radius: expected a number below 1.8e308, got 1e999"},
        BadLevel{"RadiusIsText", "\"radius\": 7", "\"radius\": \"7\"",
                 "/optic/shape/radius: expected a number from 0.000001 to 1000000, got \"7\""},
        BadLevel{"RadiusTwice", "\"radius\": 7", "\"radius\": 7, \"radius\": 8",
                 "/optic/shape/radius: expected each key once, got it twice"},
        BadLevel{"TintAboveOne", "[0.1, 0.2, 0.3]", "[0.1, 1.2, 0.3]",
                 "/optic/look/tint/1: expected a number from 0 to 1, got 1.2"},
        BadLevel{"CameraIsArray", "\"camera\": {", "\"camera\": [1, 2], \"other\": {",
                 "/camera: expected an object, got [1, 2]"},
        BadLevel{"NoEye", "\"eye\": [1, -12, 8],", "",
                 "/camera: expected the key \"eye\", got an object without it"},
        BadLevel{"EyeIsNull", "\"eye\": [1, -12, 8]", "\"eye\": null",
                 "/camera/eye: expected an array of 3 numbers, got null"},
        BadLevel{"EyeOfTwo", "\"eye\": [1, -12, 8]", "\"eye\": [1, -12]",
                 "/camera/eye: expected an array of 3 numbers, got [1, -12]"},
        BadLevel{"EyeWithText", "\"eye\": [1, -12, 8]", "\"eye\": [1, \"-12\", 8]",
                 "/camera/eye/1: expected a number from -1000000 to 1000000, got \"-12\""},
        BadLevel{"EyeFarAway", "\"eye\": [1, -12, 8]", "\"eye\": [1, -12, 1000001]",
                 "/camera/eye/2: expected a number from -1000000 to 1000000, got 1000001"},
        BadLevel{"NoUp", "\"up\": [0, 1, 0]", "\"up\": [0, 0, 0]",
                 "/camera/up: expected a vector that is not 0, got [0, 0, 0]"},
        BadLevel{"FlatField", "\"fovDegrees\": 33", "\"fovDegrees\": 180",
                 "/camera/fovDegrees: expected a number from 1 to 170, got 180"},
        BadLevel{"NarrowField", "\"fovDegrees\": 33", "\"fovDegrees\": 0.5",
                 "/camera/fovDegrees: expected a number from 1 to 170, got 0.5"},
        BadLevel{"GridTooFine", "\"grid\": [9, 7]", "\"grid\": [65, 7]",
                 "/camera/grid/0: expected a whole number from 1 to 64, got 65"},
        BadLevel{"GridWithoutRows", "\"grid\": [9, 7]", "\"grid\": [9, 0]",
                 "/camera/grid/1: expected a whole number from 1 to 64, got 0"},
        BadLevel{"GridOfHalves", "\"grid\": [9, 7]", "\"grid\": [9, 7.5]",
                 "/camera/grid/1: expected a whole number from 1 to 64, got 7.5"},
        BadLevel{"GridIsNumber", "\"grid\": [9, 7]", "\"grid\": 9",
                 "/camera/grid: expected an array of 2 numbers, got 9"},
        BadLevel{"ScreenAtEye", "\"screenDistance\": 1.5", "\"screenDistance\": 0",
                 "/camera/screenDistance: expected a number from 0.000001 to 1000000, got 0"},
        BadLevel{"UnknownOriginal", "\"torusKnot\"", "\"teapot\"",
                 "/original/shape/type: expected \"box\", \"sphere\", \"torusKnot\", \"letterF\", \"pawn\" "
                 "or \"file\", "
                 "got \"teapot\""},
        BadLevel{"FileWithoutPath", "\"torusKnot\"", "\"file\"",
                 "/original/shape: expected the key \"path\", got an object without it"},
        BadLevel{"FileWithEmptyPath", "\"torusKnot\"", "\"file\", \"path\": \"\"",
                 "/original/shape/path: expected the name of a mesh file, got \"\""},
        BadLevel{"FileWithZeroByte", "\"torusKnot\"", "\"file\", \"path\": \"a\\u0000.obj\"",
                 "/original/shape/path: expected the name of a mesh file, got \"a\\u0000.obj\""},
        BadLevel{"FileWithUnknownUp", "\"torusKnot\"", "\"file\", \"path\": \"a.obj\", \"up\": \"up\"",
                 "/original/shape/up: expected z, y, -y or x, got \"up\""},
        BadLevel{"BoxOfNoSegments", "\"torusKnot\"", "\"box\", \"size\": [6, 2, 0]",
                 "/original/shape/size/2: expected a number from 0.000001 to 1000000, got 0"},
        BadLevel{"TooManySegments", "\"segments\": 100", "\"segments\": 1e9",
                 "/original/shape/segments: expected a whole number from 3 to 4096, got 1e9"},
        BadLevel{"KnotThatIsALink", "\"q\": 4", "\"q\": 6",
                 "/original/shape/q: expected a number without a common divisor with p, got 6"},
        BadLevel{"UnitizeIsNumber", "\"unitize\": true", "\"unitize\": 1",
                 "/original/unitize: expected true or false, got 1"},
        BadLevel{"ScaleOfTwo", "\"scale\": [1, 2, 3]", "\"scale\": [1, 2]",
                 "/original/placement/scale: expected an array of 3 numbers, got [1, 2]"},
        BadLevel{"NegativeScale", "\"scale\": [1, 2, 3]", "\"scale\": -1",
                 "/original/placement/scale: expected a number from 0.000001 to 1000000, got -1"},
        BadLevel{"ScaleIsText", "\"scale\": [1, 2, 3]", "\"scale\": \"big\"",
                 "/original/placement/scale: expected a number or an array of 3 numbers, got \"big\""},
        BadLevel{"MaterialIsText", "\"material\": {\"color\": [0.5",
                 "\"material\": \"clay\", \"m\": {\"color\": [0.5",
                 "/original/material: expected an object, got \"clay\""},
        BadLevel{"NoShine", "\"shininess\": 14", "\"shininess\": 0",
                 "/original/material/shininess: expected a number from 1 to 1000, got 0"},
        BadLevel{"DepthScaleZero", "\"depthScale\": 0.5", "\"depthScale\": 0",
                 "/sculpture/depthScale: expected a number from 0.01 to 100, got 0"},
        BadLevel{"NegativeTolerance", "\"off\"", "-1",
                 "/sculpture/tolerancePixels: expected \"off\" or a number from 0.001 to 1000, got -1"},
        BadLevel{"ToleranceIsOn", "\"off\"", "\"on\"",
                 "/sculpture/tolerancePixels: expected \"off\" or a number from 0.001 to 1000, got \"on\""},
        BadLevel{"ToleranceIsFalse", "\"off\"", "false",
                 "/sculpture/tolerancePixels: expected \"off\" or a number from 0.001 to 1000, got false"},
        BadLevel{"NoTriangles", "\"maxTriangles\": 1000", "\"maxTriangles\": 0",
                 "/sculpture/maxTriangles: expected a whole number from 1 to 100000000, got 0"},
        BadLevel{"LargeImage", "\"imageSize\": 256", "\"imageSize\": 100000",
                 "/sculpture/imageSize: expected a whole number from 16 to 16384, got 100000"},
        BadLevel{"LightsAreObject", "\"lights\": [", "\"lights\": {}, \"l\": [",
                 "/lights: expected an array, got an object"},
        BadLevel{"LightIsNumber", "\"lights\": [", "\"lights\": [5, ",
                 "/lights/0: expected an object, got 5"},
        BadLevel{"LightWithoutPosition", "\"lights\": [", "\"lights\": [{}, ",
                 "/lights/0: expected the key \"position\", got an object without it"},
        BadLevel{"DarkLight", "\"intensity\": 0.9", "\"intensity\": -0.9",
                 "/lights/0/intensity: expected a number from 0 to 1000, got -0.9"},
        BadLevel{"GroundIsHidden", "\"visible\": false", "\"visible\": \"no\"",
                 "/ground/visible: expected true or false, got \"no\""},
        BadLevel{"DeepTracing", "\"maxDepth\": 5", "\"maxDepth\": 9",
                 "/tracing/maxDepth: expected a whole number from 0 to 8, got 9"},
        BadLevel{"ManySamples", "\"samplesPerAxis\": 4", "\"samplesPerAxis\": 5",
                 "/tracing/samplesPerAxis: expected a whole number from 1 to 4, got 5"},
        BadLevel{"WideView", "\"fovDegrees\": 50", "\"fovDegrees\": 171",
                 "/view/fovDegrees: expected a number from 1 to 170, got 171"},
        BadLevel{
            "BrokenAtTheEnd", "\"fovDegrees\": 50", "\"fovDegrees\" 50",
            "line 41, column 65: syntax error while parsing object separator - unexpected number literal; "
            "expected ':'"}),
    [](const auto& bad) { return std::string(bad.param.name); });

TEST(LevelJson, RefusesWhatIsNoObject) {
  for (const char* text : {"[]", "5", "null", "\"format\""}) {
    EXPECT_EQ(complaintOf(text),
              "l.json: expected a level (with \"format\": \"anamorph-level\") or a scene of the thesis (with "
              "\"Eye\" and "
              "\"Objects\"), got neither");
  }
}

TEST(LevelJson, RefusesTooManyLights) {
  Level level;
  level.lights.resize(65);
  EXPECT_EQ(complaintOf(formatLevel(level)), "l.json: /lights: expected at most 64 items, got 65");
}

TEST(LevelFile, SavedLevelsLoad) {
  const fs::path path = scratch("saved.json");
  const Level level = RandomLevel(7).make();
  saveLevel(path, level);
  EXPECT_TRUE(loadLevel(path).level == level);
  fs::remove(path);
}

TEST(LevelFile, WhatCannotBeLoadedIsNotSaved) {
  const fs::path path = scratch("kept.json");
  saveLevel(path, Level{});
  Level level;
  level.camera.fovDegrees = 0;
  EXPECT_EQ(withoutPlaces(errorOf([&] { saveLevel(path, level); })),
            path.string() + ": /camera/fovDegrees: expected a number from 1 to 170, got 0");
  level.camera.fovDegrees = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(errorOf([&] { saveLevel(path, level); }), "no error");
  level = Level{};
  level.text.edit([&](LevelText& text) { text.description = std::string(maxLevelBytes, 'x'); });
  EXPECT_NE(errorOf([&] { saveLevel(path, level); }).find(": expected a level of at most 16 MiB, got 1677"),
            std::string::npos);
  EXPECT_TRUE(loadLevel(path).level == Level{});
  fs::remove(path);
}

TEST(LevelFile, RefusesLargeMissingAndWrongFiles) {
  const fs::path path = scratch("large.json");
  writeFile(path, std::string(maxLevelBytes + 1, ' '));
  EXPECT_EQ(
      errorOf([&] { loadLevel(path); }),
      path.string() +
          ": expected at most 16 MiB, got 17 MiB; a level names its model's file instead of holding it");
  fs::remove(path);
  EXPECT_EQ(errorOf([&] { loadLevel(path); }), path.string() + ": cannot open: No such file or directory");
  EXPECT_EQ(errorOf([&] { loadLevel(path.parent_path()); }),
            path.parent_path().string() + ": expected a file, got a folder");
}

TEST(LevelFile, ModelsLieBesideTheLevel) {
  EXPECT_EQ(modelPath({"models/a.obj"}, "levels/mine.json"), fs::path("levels/models/a.obj"));
  EXPECT_EQ(modelPath({"a.obj"}, "mine.json"), fs::path("a.obj"));
  EXPECT_EQ(modelPath({"/tmp/a.obj"}, "levels/mine.json"), fs::path("/tmp/a.obj"));
}

TEST(LevelReadme, ExampleUsesEveryFieldAndIsFormattedAsSaved) {
  const std::string readme = textOf(fs::path(ANAMORPH_LEVELS) / "README.md");
  const std::size_t start = readme.find("```json\n") + 8;
  const std::string example = readme.substr(start, readme.find("```", start) - start);
  const LoadedLevel loaded = parseLevel(example, "README.md");
  EXPECT_TRUE(loaded.warnings.empty());
  EXPECT_EQ(formatLevel(loaded.level), example);
}

TEST(LevelReadme, NamesEveryShape) {
  const std::string readme = textOf(fs::path(ANAMORPH_LEVELS) / "README.md");
  for (const char* name : shapeNames())
    EXPECT_NE(readme.find("| `\"" + std::string(name) + "\"`"), std::string::npos);
  for (const char* name : originalShapes)
    EXPECT_NE(readme.find("| `\"" + std::string(name) + "\"`"), std::string::npos);
}

}  // namespace
}  // namespace anamorph
