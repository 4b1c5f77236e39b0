// The commands that draw without a window, through the program itself.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "cannot_run_here.h"
#include "cli/program.h"
#include "gl/offscreen_context.h"
#include "level/json.h"
#include "raytrace/png.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

const std::vector<std::string> levelNames{"1-plane", "2-cylinder", "3-sphere"};

std::ptrdiff_t linesIn(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

class Screenshot : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      const OffscreenContext context;
    } catch (const Error& error) {
      return cannotRunHere(error.what());
    }
  }

  // A picture of 320 x 240, or as `arguments` say.
  std::string take(const std::string& arguments, const std::string& name = "out.png") {
    const std::string path = folder / name;
    const bool sized = arguments.find("--size") != std::string::npos;
    const Result result = run("screenshot -o " + path + (sized ? " " : " --size 320x240 ") + arguments);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(linesIn(result.err), 1) << result.err;
    return path;
  }
  // The same with standard input from a file.
  std::string takeFrom(const std::string& file, const std::string& arguments) {
    const std::string path = folder / "piped.png";
    const std::string command = ANAMORPH_PROGRAM " screenshot --quiet --size 320x240 " + arguments;
    EXPECT_EQ(std::system((command + " -o " + path + " <" + file).c_str()), 0);
    return path;
  }
  Bitmap picture(const std::string& arguments) { return loadPng(take(arguments)); }

  // Fails with `code` and one line that has `word`; nothing is left.
  void expectFault(const std::string& arguments, int code, const std::string& word) {
    SCOPED_TRACE(arguments);
    const Result result = run("screenshot -o " + (folder / "none.png") + " " + arguments);
    EXPECT_EQ(result.exitCode, code);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(linesIn(result.err), 1) << result.err;
    EXPECT_THAT(result.err, HasSubstr(word));
    EXPECT_EQ(folder.fileCount(), 0u);
  }

  TemporaryFolder folder;
};

double fractionOfAlpha(const Bitmap& bitmap, int alpha) {
  std::size_t count = 0;
  for (std::size_t i = 3; i < bitmap.bytes.size(); i += 4) count += bitmap.bytes[i] == alpha;
  return 4.0 * static_cast<double>(count) / static_cast<double>(bitmap.bytes.size());
}

TEST_F(Screenshot, SameArgumentsGiveTheSameBytes) {
  for (const std::string& arguments :
       {std::string("1-plane"), std::string("3-sphere --no-panels --select-vertex 100"),
        std::string("2-cylinder --threads 1 --transparent --no-panels"),
        std::string("1-plane --step 2 --show-me")}) {
    SCOPED_TRACE(arguments);
    const std::string once = readAll(take(arguments, "a.png")), again = readAll(take(arguments, "b.png"));
    EXPECT_GT(once.size(), 1000u);
    EXPECT_TRUE(once == again);
  }
}

TEST_F(Screenshot, HasTheSizeAskedFor) {
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 300}, {320, 200}, {800, 600}}) {
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    SCOPED_TRACE(size);
    const Bitmap bitmap = loadPng(take("1-plane --size " + size));
    EXPECT_EQ(bitmap.width, width);
    EXPECT_EQ(bitmap.height, height);
    EXPECT_EQ(bitmap.channels, 3);
  }
}

TEST_F(Screenshot, TransparentHasNoBackground) {
  const Bitmap bitmap = picture("3-sphere --no-panels --transparent");
  ASSERT_EQ(bitmap.channels, 4);
  EXPECT_GT(fractionOfAlpha(bitmap, 0), 0.1) << "nothing is there";
  EXPECT_GT(fractionOfAlpha(bitmap, 255), 0.05) << "the mirror is not transparent";
}

TEST_F(Screenshot, WithoutPanelsOnlyTheViewIsLeft) {
  const Bitmap with = picture("2-cylinder --size 640x600"),
               without = picture("2-cylinder --size 640x600 --no-panels");
  EXPECT_GT(compare(with, without, 8).fractionOver, 0.3);
  // The menu bar is one colour over most of its width, the sky is not: so the rows differ.
  EXPECT_NE(std::vector(with.bytes.begin(), with.bytes.begin() + 3000),
            std::vector(without.bytes.begin(), without.bytes.begin() + 3000));
}

TEST_F(Screenshot, EveryOptionShowsSomethingElse) {
  const Bitmap plain = picture("3-sphere --no-panels");
  for (const char* option :
       {"--theme light", "--theme projector", "--look-through", "--select original", "--select mirror",
        "--select eye", "--pixel 3,3", "--select-vertex 5", "--morph 0.5", "--ui-scale 2"}) {
    SCOPED_TRACE(option);
    EXPECT_GT(compare(plain, picture(std::string("3-sphere --no-panels ") + option), 8).fractionOver, 0.0005);
  }
  const Bitmap panels = picture("3-sphere --size 640x600");
  for (const char* option : {"--preview original", "--preview difference", "--preview wipe"}) {
    SCOPED_TRACE(option);
    EXPECT_GT(compare(panels, picture(std::string("3-sphere --size 640x600 ") + option), 8).fractionOver,
              0.0005);
  }
}

TEST_F(Screenshot, FaultsLeaveNoFile) {
  expectFault("1-plane --pixel 8,0", 2, "8 x 8");
  expectFault("1-plane --pixel 0,8", 2, "--pixel");
  expectFault("1-plane --pixel -1,0", 2, "--pixel");
  expectFault("1-plane --pixel 3", 2, "--pixel");
  expectFault("1-plane --pixel 3,3,3", 2, "--pixel");
  expectFault("1-plane --select-vertex 1000000", 2, "--select-vertex");
  expectFault("1-plane --select-vertex -1", 2, "--select-vertex");
  expectFault("1-plane --theme pink", 2, "theme");
  expectFault("1-plane --morph 2", 2, "morph");
  expectFault("1-plane --ui-scale 0.1", 2, "ui-scale");
  expectFault("1-plane --step 99", 2, "--step: expected 1 (");
  expectFault("1-plane --step 0", 2, "--step: expected 1 (");
  expectFault(std::string(ANAMORPH_TEST_DATA) + "/levels/cone.json --step 1", 2, "no lesson");
  expectFault("1-plane --language xx", 2, "--language: expected en or nl, got xx");
  expectFault("1-plane no-such-mesh.obj", 1, "no-such-mesh.obj");
  expectFault("- -", 2, "expected one file from standard input, got two");
  expectFault("no-such-level", 2, "no-such-level");
  expectFault(std::string(ANAMORPH_TEST_DATA) + "/meshes/cube.obj", 1, "cube.obj");
}

// A mesh takes the original's place, fitted into its box, and fitted to nothing in a scene of the thesis, as in deform.
TEST_F(Screenshot, TakesAModel) {
  const std::string data = ANAMORPH_TEST_DATA, cube = data + "/meshes/cube.obj",
                    scene = data + "/scenes/thesis-sphere.json";
  for (const std::string& level : {std::string("3-sphere"), scene}) {
    SCOPED_TRACE(level);
    const std::string with = take(level + " --no-panels " + cube, "with.png");
    EXPECT_GT(compare(loadPng(with), picture(level + " --no-panels"), 8).fractionOver, 0.0005);
    EXPECT_EQ(readAll(takeFrom(cube, level + " - --no-panels")), readAll(with));
  }
}

TEST_F(Screenshot, TakesALevelFromStandardInput) {
  const std::string level = std::string(ANAMORPH_LEVELS) + "/2-cylinder.json";
  EXPECT_EQ(readAll(takeFrom(level, "- --no-panels")), readAll(take("2-cylinder --no-panels")));
}

TEST_F(Screenshot, SaysWhatItWroteAsJson) {
  const Result result = run("screenshot 1-plane --size 200 --json -o " + (folder / "out.png"));
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const JsonValue json = parseJson(result.out, "out");
  EXPECT_EQ(findMember(json, "path")->text, folder / "out.png");
  EXPECT_EQ(findMember(json, "width")->number, 200);
  EXPECT_EQ(findMember(json, "height")->number, 200);
}

TEST_F(Screenshot, OutputHasToBeAPngThatCanBeWritten) {
  const Result jpg = run("screenshot 1-plane -o " + (folder / "a.jpg"));
  EXPECT_EQ(jpg.exitCode, 2);
  EXPECT_THAT(jpg.err, HasSubstr(".png"));
  const Result nowhere = run("screenshot 1-plane -o " + (folder / "no/such/folder/a.png"));
  EXPECT_EQ(nowhere.exitCode, 1);
  EXPECT_EQ(linesIn(nowhere.err), 1);
  EXPECT_EQ(folder.fileCount(), 0u);
}

TEST_F(Screenshot, ALevelWithAProblemIsDrawnAndTold) {
  writeText(folder / "on.json", R"({"Eye": [0, -5, 5], "Objects": [
      {"type": "sphere", "position": [0, 0, 5], "radius": 5}, {"type": "mesh", "position": [0, 5, 1]}]})");
  const Result result =
      run("screenshot " + (folder / "on.json") + " --no-panels --size 320x240 -o " + (folder / "out.png"));
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.err, HasSubstr("the eye is on the surface of the mirror"));
  EXPECT_EQ(loadPng(folder / "out.png").width, 320);
}

// Fonts and drivers differ a little from machine to machine; what is shown does not.
TEST_F(Screenshot, LevelsLookAsTheyDid) {
  for (const std::string& name : levelNames) {
    SCOPED_TRACE(name);
    const std::string expectedPath = std::string(ANAMORPH_TEST_DATA) + "/images/window-" + name + ".png";
    const std::string path = take(name + " --no-panels --size 640x400", name + ".png");
    const Bitmap now = loadPng(path), expected = loadPng(expectedPath);
    ASSERT_EQ(now.width, expected.width);
    ASSERT_EQ(now.height, expected.height);
    ASSERT_EQ(now.channels, expected.channels);
    const BitmapDifference difference = compare(now, expected, 32);
    EXPECT_LE(difference.meanAbsolute, 3);
    EXPECT_LE(difference.fractionOver, 0.02);
    if (!HasFailure()) continue;
    const fs::path kept = fs::current_path() / ("window-" + name + "-now.png"),
                   marked = fs::current_path() / ("window-" + name + "-difference.png");
    Bitmap shown = now;
    for (std::size_t i = 0; i < shown.bytes.size(); ++i)
      shown.bytes[i] =
          static_cast<std::uint8_t>(std::min(255, 4 * std::abs(now.bytes[i] - expected.bytes[i])));
    savePng(kept, now);
    savePng(marked, shown);
    ADD_FAILURE() << "expected " << expectedPath << "\ngot " << kept << "\ndifference (4 times) " << marked;
  }
}

TEST(WithoutOpenGL, NothingIsDrawnAndItIsSaid) {
  const TemporaryFolder folder;
  for (const std::string& command :
       {"screenshot 1-plane -o " + (folder / "out.png"), std::string("bench-drag 1-plane --frames 10")}) {
    SCOPED_TRACE(command);
    const Result result = runWith(
        "env -u DISPLAY -u WAYLAND_DISPLAY __EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent LIBGL_DRIVERS_PATH=/x",
        command);
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(linesIn(result.err), 1) << result.err;
    EXPECT_THAT(result.err, HasSubstr("OpenGL 3.3"));
    EXPECT_EQ(folder.fileCount(), 0u);
  }
}

const JsonValue& member(const JsonValue& object, const std::string& key) {
  const auto at = std::find(object.keys.begin(), object.keys.end(), key);
  if (at == object.keys.end()) throw Error("no member " + key);
  return object.items[static_cast<std::size_t>(at - object.keys.begin())];
}

class BenchDrag : public Screenshot {};

TEST_F(BenchDrag, TimesEveryStage) {
  const Result result = run("bench-drag 1-plane --frames 12 --size 900x500 --json");
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const JsonValue json = parseJson(result.out, "bench-drag");
  EXPECT_EQ(member(json, "frames").number, 12);
  EXPECT_GT(member(json, "vertices").number, 1000);
  EXPECT_NE(member(json, "renderer").text, "");
  for (const char* drag : {"dragEye", "dragOriginal"}) {
    const JsonValue& stages = member(json, drag);
    for (const char* stage : {"panels and mouse", "original", "sculpture", "preview", "match", "rays",
                              "lines", "CPU without OpenGL calls", "OpenGL calls, view", "GPU, view"}) {
      SCOPED_TRACE(std::string(drag) + ", " + stage);
      const double median = member(member(stages, stage), "median").number,
                   p95 = member(member(stages, stage), "p95").number,
                   most = member(member(stages, stage), "max").number;
      EXPECT_GE(median, 0);
      EXPECT_LE(median, p95);
      EXPECT_LE(p95, most);
    }
    EXPECT_GT(member(member(stages, "sculpture"), "median").number, 0) << "it follows";
  }
  const JsonValue& actions = member(json, "actions");
  for (const char* action : {"open", "settle", "orbit", "click", "drag eye", "undo", "drag original",
                             "switch level", "save", "export", "picture of the window"}) {
    SCOPED_TRACE(action);
    EXPECT_GT(member(member(actions, action), "frames").number, 0);
    EXPECT_GT(member(member(actions, action), "longest").number, 0);
  }
}

TEST_F(BenchDrag, PutsAKnotIntoTheOriginalsPlace) {
  const Result result = run("bench-drag 1-plane --triangles 5000 --frames 10 --size 700x400 --json");
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_NEAR(member(parseJson(result.out, "bench-drag"), "triangles").number, 5000, 500);
}

TEST_F(BenchDrag, PrintsATable) {
  const Result result = run("bench-drag 3-sphere --frames 10 --size 700x400");
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("drag the eye"));
  EXPECT_THAT(result.out, HasSubstr("drag the original"));
  EXPECT_THAT(result.out, HasSubstr("p95"));
}

TEST_F(BenchDrag, WrongUsageIsTwo) {
  for (const char* arguments : {"bench-drag", "bench-drag 1 --frames 0", "bench-drag 1 --frames 1e9",
                                "bench-drag 1 --size 3x", "bench-drag 1 --triangles 0"}) {
    const Result result = run(arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments;
    EXPECT_EQ(linesIn(result.err), 1) << result.err;
  }
}

}  // namespace
}  // namespace anamorph
