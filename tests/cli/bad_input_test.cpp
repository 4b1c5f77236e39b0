// Every kind of bad input through the program: a message with the file and what was expected, the exit code,
// no output file, an existing output file untouched.

#include <algorithm>

#include <sys/stat.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;
using ::testing::HasSubstr;

const std::string data = ANAMORPH_TEST_DATA;
const std::string scene = data + "/scenes/thesis-sphere.json";
const std::string cube = data + "/meshes/cube.obj";

struct BadFile {
  std::string name;
  std::string text;
  std::string message;  // a part of it
};

void PrintTo(const BadFile& file, std::ostream* out) {
  *out << file.name;
}

// Runs deform with the bad file; an older output has to survive.
void expectRefused(const TemporaryFolder& folder, const std::string& arguments, const std::string& message) {
  writeText(folder / "out.obj", "older");
  const std::size_t before = folder.fileCount();
  const Result result = run("deform " + arguments + " -o " + (folder / "out.obj"));
  EXPECT_EQ(result.exitCode, 1) << arguments;
  EXPECT_THAT(result.err, HasSubstr(message)) << arguments;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << "one line: " << result.err;
  EXPECT_EQ(readAll(folder / "out.obj"), "older") << "untouched";
  EXPECT_EQ(folder.fileCount(), before) << "nothing left behind";
}

class BadMesh : public ::testing::TestWithParam<BadFile> {};

TEST_P(BadMesh, IsRefused) {
  const TemporaryFolder folder;
  const std::string file = folder / GetParam().name;
  writeText(file, GetParam().text);
  expectRefused(folder, scene + " " + file, GetParam().name + ": ");
  const Result result = run("deform " + scene + " " + file + " -o " + (folder / "new.obj"));
  EXPECT_THAT(result.err, HasSubstr(GetParam().message));
  EXPECT_FALSE(std::filesystem::exists(folder / "new.obj"));
}

INSTANTIATE_TEST_SUITE_P(
    All, BadMesh,
    ::testing::Values(
        BadFile{"empty.obj", "", "expected"}, BadFile{"novertex.obj", "f 1 2 3\n", "line 1"},
        BadFile{"noface.obj", "v 0 0 0\n", "expected"},
        BadFile{"nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1"},
        BadFile{"inf.obj", "v 0 0 0\nv 1 inf 0\nv 0 1 0\nf 1 2 3\n", "line 2"},
        BadFile{"1e999.obj", "v 0 0 0\nv 1 1e999 0\nv 0 1 0\nf 1 2 3\n", "line 2"},
        BadFile{"range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "line 4"},
        BadFile{"huge.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999\n", "line 4"},
        BadFile{"binary.obj", std::string("\x00\x01\x02\xff\xfe", 5), "expected"},
        BadFile{"truncated.stl", std::string(83, 'x'), "expected"},
        BadFile{"claims.ply",
                "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\n"
                "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n",
                "expected"},
        BadFile{"model.fbx", "Kaydara FBX Binary", "FBX is not read; export it as STL or OBJ"},
        BadFile{"page.stl", "<!DOCTYPE html>\n<html></html>\n", "this is an HTML page, not an STL"},
        BadFile{"comma.obj", "v 0,0 0,0 0,0\nv 1,0 0,0 0,0\nv 0,0 1,0 0,0\nf 1 2 3\n", "decimal comma"}),
    [](const auto& each) { return "Case" + std::to_string(each.index); });

class BadScene : public ::testing::TestWithParam<BadFile> {};

TEST_P(BadScene, IsRefused) {
  const TemporaryFolder folder;
  const std::string file = folder / GetParam().name;
  writeText(file, GetParam().text);
  expectRefused(folder, file + " " + cube, GetParam().message);
}

std::string sceneText(const std::string& eye, const std::string& mirror,
                      const std::string& position = "[0, 5, 1]") {
  return "{\"Eye\": " + eye + ", \"Objects\": [" + mirror +
         ", {\"type\": \"mesh\", \"position\": " + position + "}]}";
}
std::string sphereText(const std::string& radius) {
  return "{\"type\": \"sphere\", \"position\": [0, 0, 5], \"radius\": " + radius + "}";
}

INSTANTIATE_TEST_SUITE_P(
    All, BadScene,
    ::testing::Values(
        BadFile{"empty.json", "", "expected"}, BadFile{"deep.json", std::string(100000, '['), "deep"},
        BadFile{"utf8.json", "{\"title\": \"\xff\"}", "UTF-8"},
        BadFile{"type.json", sceneText("\"here\"", sphereText("5")), "/Eye"},
        BadFile{"negative.json", sceneText("[0, -12, 5]", sphereText("-5")), "/Objects/0/radius"},
        BadFile{"tiny.json", sceneText("[0, -12, 5]", sphereText("1e-300")), "/Objects/0/radius"},
        BadFile{"large.json", sceneText("[0, -12, 5]", sphereText("1e300")), "/Objects/0/radius"},
        BadFile{"inf.json", sceneText("[0, -12, 5]", sphereText("1e999")), "inf.json"},
        BadFile{"keys.json", "{\"Eye\": [0, 0, 0], \"Eye\": [0, 0, 0]}", "Eye"},
        BadFile{"on.json", sceneText("[0, -5, 5]", sphereText("5")),
                "the eye is on the surface of the mirror"},
        BadFile{"around.json", sceneText("[0, -12, 5]", sphereText("5"), "[0, -12, 5]"),
                "inside the original's box"},
        BadFile{"front.json", sceneText("[0, -12, 5]", sphereText("5"), "[0, -7.5, 5]"),
                "between the eye and the mirror"},
        BadFile{"beside.json", sceneText("[0, -12, 5]", sphereText("5"), "[30, 5, 5]"),
                "never meets the mirror"},
        BadFile{"quad.json",
                sceneText("[0, -12, 5]",
                          "{\"type\": \"quad\", \"v0\": [1, 0, 0], \"v1\": [1, 0, 0], \"v2\": [1, 0, 0], "
                          "\"v3\": [1, 0, "
                          "0]}"),
                "area 0"}),
    [](const auto& each) { return "Case" + std::to_string(each.index); });

TEST(BadInput, FoldersMissingFilesAndPermissions) {
  const TemporaryFolder folder;
  expectRefused(folder, scene + " /tmp", ".obj");
  std::filesystem::create_directory(folder / "folder.obj");
  expectRefused(folder, scene + " " + (folder / "folder.obj"), "expected a file, got a folder");
  expectRefused(folder, scene + " nothing.obj", "nothing.obj: cannot open: No such file or directory");
  expectRefused(folder, "nothing.json " + cube, "nothing.json");
  if (::geteuid() != 0) {
    writeText(folder / "secret.obj", "v 0 0 0\n");
    ::chmod((folder / "secret.obj").c_str(), 0);
    expectRefused(folder, scene + " " + (folder / "secret.obj"), "Permission denied");
  }
}

TEST(BadInput, FullDiskIsSaid) {
  for (const char* command : {"deform 1-plane -o ", "render 1-plane --size 32x32 -o "}) {
    const TemporaryFolder folder;
    const std::string name = folder / (command[0] == 'd' ? "full.obj" : "full.png");
    std::filesystem::create_symlink("/dev/full", name);
    const Result result = run(command + name);
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_THAT(result.err, HasSubstr("cannot write: No space left on device"));
    EXPECT_EQ(folder.fileCount(), 1u);
  }
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
  for (const char* command : {"levels", "match 1-plane --size 32 --json", "check 1-plane"}) {
    const TemporaryFolder folder;
    const int status = std::system(
        (std::string(ANAMORPH_PROGRAM) + " " + command + " >/dev/full 2>" + (folder / "err")).c_str());
    EXPECT_EQ(WEXITSTATUS(status), 1) << command;
    EXPECT_THAT(readAll(folder / "err"), HasSubstr("No space left on device")) << command;
  }
}

TEST(BadInput, MeshWithoutAreaIsExplained) {
  const TemporaryFolder folder;
  writeText(folder / "point.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n");
  expectRefused(folder, scene + " " + (folder / "point.obj"), "no triangle of the original has an area");
  EXPECT_EQ(run("check " + (folder / "point.obj")).exitCode, 1);
}

TEST(BadInput, MissingModelNamesTheLevel) {
  const TemporaryFolder folder;
  std::string level = readAll(std::string(ANAMORPH_LEVELS) + "/1-plane.json");
  const std::string shape = "{\"type\": \"box\", \"size\": [6, 2, 2], \"segments\": 32}";
  ASSERT_NE(level.find(shape), std::string::npos);
  level.replace(level.find(shape), shape.size(), "{\"type\": \"file\", \"path\": \"zzz.obj\"}");
  writeText(folder / "level.json", level);
  expectRefused(folder, folder / "level.json", "level.json: /original/shape/path: ");
}

TEST(BadInput, OutputThatCannotBeMade) {
  EXPECT_EQ(run("deform 1-plane -o /proc/s.obj").exitCode, 1) << "no permission, not even for root";
  EXPECT_EQ(run("deform 1-plane -o /nothing/there/s.obj").exitCode, 1);
  EXPECT_THAT(run("deform 1-plane -o /nothing/there/s.obj").err,
              HasSubstr("/nothing/there/s.obj: cannot write: No such file or directory"));
}

TEST(BadInput, LimitsNameTheirOption) {
  const TemporaryFolder folder;
  expectRefused(folder, scene + " " + data + "/meshes/box.obj --max-vertices 100", "--max-vertices");
  writeText(folder / "long.obj", std::string(3 << 20, '#'));
  expectRefused(folder, scene + " " + (folder / "long.obj") + " --max-mesh-mb 2", "--max-mesh-mb");
}

TEST(BadInput, ByteOrderMarkAndCarriageReturnsAreFine) {
  const TemporaryFolder folder;
  writeText(folder / "dos.obj", "\xef\xbb\xbfv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n");
  writeText(folder / "dos.json", "\xef\xbb\xbf" + sceneText("[0, -12, 5]", sphereText("5")) + "\r\n");
  const Result result =
      run("deform " + (folder / "dos.json") + " " + (folder / "dos.obj") + " -o " + (folder / "s.obj"));
  EXPECT_EQ(result.exitCode, 0) << result.err;
}

}  // namespace
}  // namespace anamorph
