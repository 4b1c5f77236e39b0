#include <algorithm>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/mesh_files.h"
#include "level/json.h"
#include "level/level_json.h"
#include "program.h"
#include "raytrace/png.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string data = ANAMORPH_TEST_DATA;
const std::string cube = data + "/meshes/cube.obj";
const std::string sphereScene = data + "/scenes/thesis-sphere.json";
const std::string cylinderScene = data + "/scenes/thesis-cylinder.json";
// The eye is on the mirror.
const std::string touchingScene = R"({"Eye": [0, -5, 5], "Objects": [
    {"type": "sphere", "position": [0, 0, 5], "radius": 5}, {"type": "mesh", "position": [0, 5, 1]}]})";

const JsonValue& member(const JsonValue& object, const std::string& key) {
  const auto at = std::find(object.keys.begin(), object.keys.end(), key);
  if (at == object.keys.end()) throw Error("no member " + key);
  return object.items[std::size_t(at - object.keys.begin())];
}

TEST(Program, HelpAndVersion) {
  EXPECT_EQ(run("--version").exitCode, 0);
  EXPECT_THAT(run("--version").out, HasSubstr("anamorph 0."));
  const Result help = run("-h");
  EXPECT_EQ(help.exitCode, 0);
  for (const char* command : {"deform", "match", "render", "check", "levels"}) {
    EXPECT_THAT(help.out, HasSubstr(command));
    EXPECT_EQ(run(std::string(command) + " -h").exitCode, 0);
  }
}

TEST(Program, WrongUsageIsTwo) {
  for (const std::string& arguments : std::vector<std::string>{"nonsense",
                                                               "deform",
                                                               "match 1 --size 0",
                                                               "match 1 --size 64x0",
                                                               "export 1 -o x.png --size 8x64",
                                                               "export 1 -o x.pdf --language xx",
                                                               "match 1 --tolerance fine",
                                                               "render 1 -o x.png --size 5x",
                                                               "render 1 -o x.png --size 5x-5",
                                                               "render 1 -o x.gif",
                                                               "deform 1 -o x.txt",
                                                               "deform 1 -o x.obj --depth-scale 0",
                                                               "match 1 --threads 0",
                                                               "render 1 -o x.png --view sideways",
                                                               "check",
                                                               "match 1 --tolerance -1",
                                                               "match 1 --fov nan",
                                                               "deform 1 -o x.obj --depth-scale nan",
                                                               "match 1 --tolerance nan",
                                                               "deform 1 -o x.obj --mm-per-unit nan",
                                                               "render 1 -o x.png --fov inf",
                                                               "defrom 1",
                                                               "levels --size 64",
                                                               "render 1 -o x.png --size 16384x16384",
                                                               "render 1 -o x.png --size 99999999999x5",
                                                               "match " + cube}) {
    const Result result = run(arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << arguments << ": " << result.err;
    EXPECT_EQ(result.out, "") << arguments;
  }
  for (const char* word : {"defrom", "9-none", "'1-plane '"}) {
    const Result unknown = run(word);
    EXPECT_EQ(unknown.exitCode, 2) << word;
    EXPECT_THAT(unknown.err, HasSubstr("expected a command (deform, match, render, check, levels, schema"));
    EXPECT_THAT(unknown.err, HasSubstr("), got "));
  }
  EXPECT_THAT(run("match 1 --fov nan").err, HasSubstr("--fov: expected a number from 1 to 170, got nan"));
  EXPECT_THAT(run("match " + cube).err, HasSubstr("is a mesh: name a level or a scene first"));
  const Result noModel = run("match " + sphereScene);
  EXPECT_EQ(noModel.exitCode, 2);
  EXPECT_THAT(noModel.err, HasSubstr("Name one after it"));
}

#ifdef ANAMORPH_GUI
TEST(Program, OpenIsACommandAndWhatALevelAloneMeans) {
  for (const char* arguments : {"open --help", "open -h", "1-plane --help", "plane -h", "--fullscreen -h"}) {
    const Result help = run(arguments);
    EXPECT_EQ(help.exitCode, 0) << arguments << ": " << help.err;
    EXPECT_THAT(help.out, HasSubstr("Usage: anamorph open [OPTIONS] [LEVEL]")) << arguments;
    EXPECT_EQ(help.err, "") << arguments;
  }
  for (const char* command : {"open", "screenshot"}) EXPECT_THAT(run("--help").out, HasSubstr(command));
  // None of these comes as far as a window.
  for (const char* arguments :
       {"open --bogus", "1-plane --bogus", "--bogus", "open --size 5x", "1 --theme pink", "open --ui-scale 9",
        "1 --ui-scale nan", "open 1 a.obj b.obj"}) {
    const Result result = run(arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << arguments << ": " << result.err;
  }
  const Result noMesh = run("1-plane 2-cylinder");
  EXPECT_EQ(noMesh.exitCode, 1);
  EXPECT_THAT(noMesh.err, HasSubstr("2-cylinder: expected a file name that ends in .obj, .stl or .ply"));
  const Result nothing = run("open nothing");
  EXPECT_EQ(nothing.exitCode, 2);
  EXPECT_THAT(nothing.err,
              HasSubstr("expected a file or one of the levels 0-perspective, 1-plane, 2-cylinder"));
}
#else
TEST(Program, WithoutAWindowACommandIsNeeded) {
  EXPECT_EQ(run("").exitCode, 2);
  EXPECT_EQ(run("1-plane").exitCode, 2);
  EXPECT_THAT(run("open").err, HasSubstr("expected a command"));
}
#endif

TEST(Deform, WritesTheSculptureInEveryFormat) {
  const TemporaryFolder folder;
  for (const char* name : {"s.obj", "s.stl", "s.ply"}) {
    const Result result = run("deform " + sphereScene + " " + cube + " -o " + (folder / name));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const Mesh mesh = loadMesh(folder / name).mesh;
    EXPECT_TRUE(isClosed(mesh)) << name;
    EXPECT_GT(signedVolume(mesh), 0) << name;
  }
}

TEST(Deform, OffKeepsVerticesAndOrder) {
  const TemporaryFolder folder;
  ASSERT_EQ(run("deform " + sphereScene + " " + cube + " --tolerance off -o " + (folder / "s.obj")).exitCode,
            0);
  std::ifstream expected(data + "/expected/thesis-sphere-cube.txt");
  const Mesh mesh = loadMesh(folder / "s.obj").mesh;
  ASSERT_EQ(mesh.positions.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    Point p;
    expected >> p.x >> p.y >> p.z;
    EXPECT_LT(glm::length(mesh.positions[i] - p), 1e-12 * 20);
  }
}

TEST(Deform, JsonTellsWhatWasMade) {
  const TemporaryFolder folder;
  const Result result = run("deform 2-cylinder --json --mm-per-unit 10 -o " + (folder / "s.obj"));
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const JsonValue json = parseJson(result.out, "stdout");
  EXPECT_THAT(json.keys, ElementsAre("vertices", "triangles", "status", "unmappedVertices", "budgetHit",
                                     "bounds", "seconds"));
  EXPECT_THAT(member(json, "status").keys,
              ElementsAre("mapped", "missesMirror", "inFrontOfMirror", "grazing", "hitsMirrorAgain"));
  EXPECT_THAT(member(json, "seconds").keys, ElementsAre("load", "deform", "write"));
  const Mesh mesh = loadMesh(folder / "s.obj").mesh;
  EXPECT_EQ(member(json, "vertices").number, double(mesh.positions.size()));
  EXPECT_EQ(member(json, "triangles").number, double(mesh.triangles.size()));
  EXPECT_NEAR(member(member(json, "bounds"), "max").items[0].number, boundingBox(mesh.positions).max.x, 1e-9);
  EXPECT_GT(boundingBox(mesh.positions).size().x, 40) << "in millimetres";
}

TEST(Deform, UnmappedVerticesKeepTheirLineAndLoseTheirFaces) {
  const TemporaryFolder folder;
  // One corner of the cube is in front of the mirror's plane.
  writeText(folder / "wedge.obj", "v 0 -11 0\nv 1 1 0\nv 1 1 1\nv -1 1 1\nf 1 2 3\nf 2 3 4\n");
  const Result result = run("deform " + data + "/scenes/thesis-flat.json " + (folder / "wedge.obj") +
                            " --tolerance off --json -o " + (folder / "s.obj"));
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("3 of 4 vertices mapped (1 are in front of the mirror)"));
  const std::string written = readAll(folder / "s.obj");
  EXPECT_THAT(written, HasSubstr("\nv 2 -1 1\n")) << "the original's place";
  std::size_t vertices = 0;
  for (std::size_t at = 0; (at = written.find("\nv ", at)) != std::string::npos; ++at) ++vertices;
  EXPECT_EQ(vertices, 4u);
  EXPECT_EQ(loadMesh(folder / "s.obj").mesh.triangles.size(), 1u);
  EXPECT_EQ(member(parseJson(result.out, "out"), "unmappedVertices").text,
            "original position kept, faces dropped");
}

// Its eye is within the cylinder, continued, and sees the far wall through the open end.
TEST(Deform, ThesisCylinderIsMappedInPartAndSaysSo) {
  const TemporaryFolder folder;
  const Result result = run("deform " + cylinderScene + " " + data + "/meshes/box.obj --tolerance off -o " +
                            (folder / "s.obj"));
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(
      result.err,
      HasSubstr(
          "1667 of 6146 vertices mapped (51 miss the mirror, 4428 are in front of the mirror); faces with "
          "an unmapped corner are left out"));
  EXPECT_FALSE(loadMesh(folder / "s.obj").mesh.triangles.empty());
}

TEST(Deform, WhatIsWrongWithTheEyeIsExplainedAndNothingIsWritten) {
  const TemporaryFolder folder;
  writeText(folder / "on.json", touchingScene);
  const Result result = run("deform " + (folder / "on.json") + " " + cube + " -o " + (folder / "s.obj"));
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("the eye is on the surface of the mirror"));
  EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(Deform, ModelForALevelIsFittedIntoItsOriginal) {
  const TemporaryFolder folder;
  writeText(folder / "huge.obj",
            "v 0 0 0\nv 900 0 0\nv 0 900 0\nv 0 0 900\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const Result result = run("match 1-plane " + (folder / "huge.obj") + " --json");
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const JsonValue json = parseJson(result.out, "out");
  EXPECT_EQ(member(json, "grade").text, "excellent");
  EXPECT_EQ(member(json, "missedShare").number, 0);
}

// A house of 2 x 1 x 1.8 that lies on its back, in the plane level's box of 6 x 2 x 2.
TEST(ModelUp, TurnsAModelAndTheMeshOfALevel) {
  const TemporaryFolder folder;
  const std::string house = data + "/field/obj-y-up/house.obj";
  const auto heightOf = [&](const std::string& input) {
    const Result result = run("deform " + input + " --tolerance off -o " + (folder / "s.ply"));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const Vector size = boundingBox(loadMesh(folder / "s.ply").mesh.positions).size();
    return size.z / size.x;
  };
  const auto level = [&](const std::string& up) {
    Level saved = loadLevel(std::string(ANAMORPH_LEVELS) + "/1-plane.json").level;
    saved.original.shape = FileShape{.path = house, .up = *findModelUp(up)};
    saveLevel(folder / "mine.json", saved);
    return folder / "mine.json";
  };
  const std::string plane = "1-plane " + house;
  EXPECT_NEAR(heightOf(plane), 0.5, 1e-6);
  EXPECT_NEAR(heightOf(plane + " --model-up z"), 0.5, 1e-6);
  for (const char* up : {"y", "-y", "auto"})
    EXPECT_NEAR(heightOf(plane + " --model-up " + up), 0.9, 1e-6) << up;
  EXPECT_NEAR(heightOf(plane + " --model-up x"), 2, 1e-6);
  EXPECT_NEAR(heightOf(level("z")), 0.5, 1e-6);
  EXPECT_NEAR(heightOf(level("y")), 0.9, 1e-6);
  EXPECT_NEAR(heightOf(level("y") + " --model-up z"), 0.5, 1e-6);
  EXPECT_NEAR(heightOf(level("x") + " --model-up auto"), 0.9, 1e-6);
  const Result said = run("match " + plane + " --model-up auto --size 64");
  EXPECT_NE(said.err.find("Its y axis is taken to point up"), std::string::npos) << said.err;
  for (const char* command : {"match", "render", "export", "deform"}) {
    const Result help = run(std::string(command) + " --help");
    EXPECT_NE(help.out.find("--model-up"), std::string::npos) << command;
    EXPECT_NE(help.out.find("a model is turned by --model-up instead"), std::string::npos) << help.out;
  }
  EXPECT_EQ(run("match 1-plane --model-up y").exitCode, 2) << "it has no mesh file";
  EXPECT_EQ(run("match " + plane + " --model-up w").exitCode, 2);
}

TEST(Match, JsonHasEveryFigure) {
  const Result result = run("match 3-sphere --size 200 --json");
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const JsonValue json = parseJson(result.out, "out");
  EXPECT_THAT(json.keys, ElementsAre("size", "width", "height", "originalPixels", "contourPx",
                                     "silhouetteIou", "correspondencePx", "triangleAgreement", "hiddenShare",
                                     "missedShare", "foldedShare", "extraShare", "grade", "status"));
  EXPECT_THAT(member(json, "correspondencePx").keys, ElementsAre("mean", "p99", "max"));
  EXPECT_EQ(member(json, "size").number, 200);
  EXPECT_GE(member(json, "silhouetteIou").number, 0.99);
}

TEST(Match, DepthScaleChangesTheSculptureNotTheImage) {
  for (const char* k : {"0.3", "1.5"}) {
    const Result result =
        run(std::string("match ") + sphereScene + " " + cube + " --json --depth-scale " + k);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_GE(member(parseJson(result.out, "out"), "silhouetteIou").number, 0.995) << k;
  }
}

TEST(Deform, ImageSizeComesFromTheLevelUnlessGiven) {
  const TemporaryFolder folder;
  std::string level = readAll(std::string(ANAMORPH_LEVELS) + "/2-cylinder.json");
  const std::string key = "\"imageSize\": 512";
  ASSERT_NE(level.find(key), std::string::npos);
  level.replace(level.find(key), key.size(), "\"imageSize\": 8192");
  writeText(folder / "fine.json", level);
  const auto triangles = [&](const std::string& arguments) {
    const Result result = run("deform " + arguments + " --json -o " + (folder / "s.obj"));
    return result.exitCode == 0 ? member(parseJson(result.out, "out"), "triangles").number : 0;
  };
  const double coarse = triangles("2-cylinder"), fine = triangles(folder / "fine.json");
  EXPECT_GT(fine, 2 * coarse);
  EXPECT_EQ(triangles("2-cylinder --image-size 8192"), fine);
}

TEST(Warnings, BudgetGroundAndUnmappedVerticesAreSaidByEveryCommand) {
  const TemporaryFolder folder;
  std::string level = readAll(std::string(ANAMORPH_LEVELS) + "/2-cylinder.json");
  const auto replace = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(level.find(from), std::string::npos) << from;
    level.replace(level.find(from), from.size(), to);
  };
  replace("\"maxTriangles\": 2000000", "\"maxTriangles\": 13000");
  replace("\"tolerancePixels\": 0.25", "\"tolerancePixels\": 0.01");
  replace("\"height\": 0", "\"height\": 5");
  writeText(folder / "level.json", level);
  for (const std::string& arguments :
       {"match " + (folder / "level.json"),
        "render " + (folder / "level.json") + " --size 64x64 -o " + (folder / "p.png"),
        "deform " + (folder / "level.json") + " -o " + (folder / "s.obj"),
        "check " + (folder / "level.json")}) {
    const Result result = run(arguments);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("refinement stopped at the budget of 13000 triangles")) << arguments;
    EXPECT_THAT(result.err, HasSubstr("below the ground")) << arguments;
  }
}

TEST(Render, EveryViewAtAnySize) {
  const TemporaryFolder folder;
  for (const char* view : {"reflection", "original", "difference"}) {
    const Result result = run(std::string("render 1-plane --size 90x60 --samples 1 --view ") + view + " -o " +
                              (folder / "p.png"));
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const Bitmap picture = loadPng(folder / "p.png");
    EXPECT_EQ(picture.width, 90);
    EXPECT_EQ(picture.height, 60);
  }
}

TEST(Render, SameForEveryThreadCount) {
  const TemporaryFolder folder;
  ASSERT_EQ(run("render 2-cylinder --size 64x64 --threads 1 -o " + (folder / "1.png")).exitCode, 0);
  ASSERT_EQ(run("render 2-cylinder --size 64x64 --threads 4 -o " + (folder / "4.png")).exitCode, 0);
  EXPECT_EQ(readAll(folder / "1.png"), readAll(folder / "4.png"));
}

TEST(Check, NamesWhatIsFineAndWhatIsNot) {
  const Result good = run("check 1-plane " + sphereScene + " " + cube);
  EXPECT_EQ(good.exitCode, 0) << good.err;
  EXPECT_THAT(good.out, HasSubstr("1-plane: level \"The plane mirror\", plane mirror, 6146 of 6146 vertices "
                                  "mapped, match excellent"));
  EXPECT_THAT(good.out, HasSubstr("thesis scene, sphere mirror"));
  EXPECT_THAT(good.out, HasSubstr("mesh, 8 vertices, 12 triangles, 2 x 2 x 2, closed"));
  const TemporaryFolder folder;
  writeText(folder / "on.json", touchingScene);
  const Result bad = run("check " + (folder / "on.json") + " nothing.obj 1-plane");
  EXPECT_EQ(bad.exitCode, 1);
  EXPECT_THAT(bad.err, HasSubstr("the eye is on the surface of the mirror"));
  EXPECT_THAT(bad.err, HasSubstr("nothing.obj: cannot open: No such file or directory"));
  EXPECT_THAT(bad.err, HasSubstr("2 of 3 files have faults"));
  EXPECT_THAT(bad.out, HasSubstr("1-plane: level"));
}

TEST(Check, SaysWhatOfAMeshTroublesAPrinter) {
  const TemporaryFolder folder;
  // A tetrahedron that faces inwards, and a second one with a face twice.
  writeText(folder / "turned.obj",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
  writeText(folder / "double.obj",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nf 2 3 4\n");
  const Result turned = run("check " + (folder / "turned.obj")),
               doubled = run("check " + (folder / "double.obj"));
  EXPECT_EQ(turned.exitCode, 0);
  EXPECT_THAT(turned.err, HasSubstr("turned.obj: 1 closed part is inside out"));
  EXPECT_THAT(doubled.err, HasSubstr("double.obj: 1 triangle is there twice"));
  EXPECT_THAT(run("check " + cube).err, ::testing::IsEmpty());
}

// What a mesh file has lost is said by every command that reads it, and hinders none.
TEST(Check, SaysWhatOfAMeshWasLeftOut) {
  const TemporaryFolder folder;
  const std::string mesh = folder / "house.obj";
  writeText(mesh, readAll(cube) + "\nv 5000 5000 5000\nf 1 2\n");
  const std::string shortFace = "1 face of fewer than three corners left out\n";
  const Result checked = run("check " + mesh);
  EXPECT_EQ(checked.exitCode, 0) << checked.err;
  EXPECT_THAT(checked.out, HasSubstr("mesh, 8 vertices, 12 triangles, 2 x 2 x 2, closed"));
  EXPECT_THAT(checked.err, HasSubstr("warning: " + mesh + ": line "));
  EXPECT_THAT(checked.err, HasSubstr(shortFace));
  EXPECT_THAT(checked.err, HasSubstr("1 vertex that no face uses left out\n"));
  const Result deformed = run("deform " + sphereScene + " " + mesh + " -o " + (folder / "s.obj"));
  EXPECT_EQ(deformed.exitCode, 0) << deformed.err;
  EXPECT_THAT(deformed.err, HasSubstr(shortFace));
  EXPECT_EQ(run("check --quiet " + mesh).err, "");
}

TEST(Check, NamesOtherFormatsAndLooksIntoFilesWithoutAnEnding) {
  const TemporaryFolder folder;
  writeText(folder / "part.step", "ISO-10303-21;\n");
  writeText(folder / "noending", readAll(cube));
  const Result step = run("check " + (folder / "part.step"));
  EXPECT_EQ(step.exitCode, 1);
  EXPECT_THAT(step.err, HasSubstr("part.step: STEP is not read; export it as STL or OBJ\n"));
  const Result mesh = run("check " + (folder / "noending"));
  EXPECT_EQ(mesh.exitCode, 0) << mesh.err;
  EXPECT_THAT(mesh.out, HasSubstr("mesh, 8 vertices, 12 triangles"));
}

TEST(Levels, ListsWhatIsInstalled) {
  const Result list = run("levels");
  EXPECT_EQ(list.exitCode, 0);
  for (const char* name : {"0-perspective", "1-plane", "2-cylinder", "3-sphere", "4-mistakes", "5-cone",
                           "6-hollow", "7-free-form", "sandbox"}) {
    EXPECT_THAT(list.out, HasSubstr(name));
  }
  const TemporaryFolder folder;
  const Result table = run("levels --size 64 -o " + (folder / "out"));
  EXPECT_EQ(table.exitCode, 0) << table.err;
  EXPECT_THAT(table.out, HasSubstr("excellent"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/1-plane.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/3-sphere.obj"));
}

TEST(Quiet, KeepsErrorsAndResultsOnly) {
  const TemporaryFolder folder;
  EXPECT_EQ(run("deform 1-plane --quiet -o " + (folder / "s.obj")).err, "");
  EXPECT_NE(run("deform nothing --quiet -o " + (folder / "t.obj")).err, "");
}

}  // namespace
}  // namespace anamorph
