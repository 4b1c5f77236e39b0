// What commands read and where they write to: the same file under every name, what is no file, standard input and
// output. A command that hangs is ended and so fails.

#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/mesh_files.h"
#include "level/level_json.h"
#include "program.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;
namespace fs = std::filesystem;
using ::testing::HasSubstr;

struct Case {
  const char* line;  // in a shell; @ is the program
  int exitCode;
  const char* message;                    // a part of stderr
  std::vector<std::string> written = {};  // files that are new or different afterwards
};

void PrintTo(const Case& each, std::ostream* out) {
  *out << each.line;
}

class InputsAndOutputs : public ::testing::TestWithParam<Case> {
 protected:
  InputsAndOutputs() {
    Level level = loadLevel(fs::path(ANAMORPH_LEVELS) / "1-plane.json").level;
    level.original.shape = FileShape{"b.obj"};
    level.text.edit([](LevelText& text) { text.lesson.clear(); });  // it picks vertices that the mesh has not
    saveLevel(at("my.json"), level);
    saveLevel(at("level"), level);
    fs::copy_file(std::string(ANAMORPH_TEST_DATA) + "/meshes/cube.obj", at("b.obj"));
    fs::copy_file(at("b.obj"), at("model.obj"));
    saveMesh(at("model.stl"), loadMesh(at("b.obj")).mesh);
    saveMesh(at("model.ply"), loadMesh(at("b.obj")).mesh);
    fs::create_directory(at("a"));
    fs::create_directory(at("folder.obj"));
    fs::create_symlink("b.obj", at("link.obj"));
    fs::create_symlink("my.json", at("link.json"));
    fs::create_symlink("my.json", at("link.png"));
    fs::create_symlink("new.obj", at("dangling.obj"));
    fs::create_hard_link(at("b.obj"), at("hard.obj"));
    fs::create_hard_link(at("my.json"), at("hard.json"));
    for (const char* name : {"zero", "zero.json", "zero.obj"}) fs::create_symlink("/dev/zero", at(name));
    for (const char* name : {"pipe", "pipe.json", "pipe.obj"}) ::mkfifo(at(name).c_str(), 0600);
    for (const char* name : {"empty.json", "empty.obj"}) writeText(at(name), "");
    level.optic.shape() = MeshMirror{{"b.obj", nullptr, {}}, {}};
    level.original.shape = BoxShape{};
    saveLevel(at("mirror.json"), level);
    level.optic.shape() = MeshMirror{{"gone.obj", nullptr, {}}, {}};
    saveLevel(at("no-mirror.json"), level);
    level.optic.shape() = PlaneMirror{};
    level.original.shape = FileShape{"pipe.obj"};
    saveLevel(at("pipe-mesh.json"), level);
  }
  std::string at(const std::string& name) const { return folder_ / name; }

  // Names of all files, and what is in the regular ones.
  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(at(""))) {
      const std::string name = entry.path().lexically_relative(at("")).string();
      files[name] = fs::is_regular_file(entry.path()) ? readAll(entry.path()) : "";
    }
    return files;
  }
  Result runLine(std::string line) const {
    const TemporaryFolder results;
    const std::string program = "timeout 30 " + std::string(ANAMORPH_PROGRAM);
    for (std::size_t i; (i = line.find('@')) != std::string::npos;) line.replace(i, 1, program);
    const std::string command = "cd " + at("") + " && { " + line + " ; } </dev/null >" + (results / "out") +
                                " 2>" + (results / "err");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readAll(results / "out"), readAll(results / "err")};
  }

 private:
  TemporaryFolder folder_;
};

TEST_P(InputsAndOutputs, AreWhatIsMeant) {
  const auto before = contents();
  const Result result = runLine(GetParam().line);
  EXPECT_EQ(result.exitCode, GetParam().exitCode) << (result.exitCode == 124 ? "it hangs" : "") << result.err;
  EXPECT_THAT(result.err, HasSubstr(GetParam().message));
  std::vector<std::string> written;
  for (const auto& [name, text] : contents()) {
    const auto old = before.find(name);
    if (old == before.end() || old->second != text) written.push_back(name);
  }
  EXPECT_EQ(written, GetParam().written);
  for (const auto& [name, text] : before)
    EXPECT_TRUE(fs::is_symlink(at(name)) || fs::exists(at(name))) << name;
}

std::string named(::testing::TestParamInfo<Case> each) {
  return "Case" + std::to_string(each.index);
}

INSTANTIATE_TEST_SUITE_P(
    AnOutputThatIsRead, InputsAndOutputs,
    ::testing::Values(Case{"@ export my.json -o my.json", 2,
                           "my.json: this command reads it; choose another name"},
                      Case{"@ export my.json -o ./a/../my.json", 2,
                           "./a/../my.json: this is my.json, which this command reads; choose another name"},
                      Case{"@ export my.json -o link.json", 2, "link.json: this is my.json, which"},
                      Case{"@ export link.json -o my.json", 2, "my.json: this is link.json, which"},
                      Case{"@ export hard.json -o my.json", 2, "my.json: this is hard.json, which"},
                      Case{"@ export my.json -o \"$PWD/my.json\"", 2, "my.json, which this command reads"},
                      Case{"@ export my.json -o b.obj", 2, "b.obj: this command reads it"},
                      Case{"@ export my.json -o hard.obj", 2, "hard.obj: this is b.obj, which"},
                      Case{"@ export a/../my.json -o b.obj", 2, "b.obj: this is a/../b.obj, which"},
                      Case{"@ export my.json model.obj -o b.obj", 2, "b.obj: this command reads it"},
                      Case{"@ export my.json -o sheet.pdf -o link.obj", 2, "link.obj: this is b.obj"},
                      Case{"@ export my.json --rays vertices -o b.obj", 2, "b.obj: this command reads it"},
                      Case{"@ deform my.json b.obj -o b.obj", 2, "b.obj: this command reads it"},
                      Case{"@ deform my.json model.obj -o model.obj", 2, "model.obj: this command reads it"},
                      Case{"@ deform my.json model.obj -o ./model.obj", 2, "./model.obj: this is model.obj"},
                      Case{"@ deform 1-plane link.obj -o b.obj", 2, "b.obj: this is link.obj"},
                      Case{"@ deform 1-plane - -o b.obj <b.obj", 2, "b.obj: this is /dev/stdin"},
                      Case{"@ export - -o my.json <my.json", 2, "my.json: this is /dev/stdin"},
                      Case{"@ deform 1-plane b.obj -o - --format obj >>b.obj", 2, "-: this is b.obj"},
                      Case{"@ render my.json -o link.png", 2, "link.png: this is my.json"}),
    named);

INSTANTIATE_TEST_SUITE_P(
    AMirrorFromAFile, InputsAndOutputs,
    ::testing::Values(Case{"@ deform mirror.json -o b.obj", 2, "b.obj: this command reads it"},
                      Case{"@ deform mirror.json -o hard.obj", 2, "hard.obj: this is b.obj, which"},
                      Case{"@ export mirror.json -o link.obj", 2, "link.obj: this is b.obj, which"},
                      Case{"@ deform no-mirror.json -o new.obj", 1,
                           "no-mirror.json: /optic/shape: the mesh mirror cannot be used: gone.obj: cannot open: No such "
                           "file or directory."},
                      Case{"@ render no-mirror.json -o new.png", 1,
                           "the mesh mirror cannot be used: gone.obj: cannot open"},
                      Case{"@ check no-mirror.json", 1,
                           "the mesh mirror cannot be used: gone.obj: cannot open"},
                      Case{"@ check mirror.json", 0, "of 6146 vertices mapped"}),
    named);

#ifdef ANAMORPH_GUI
INSTANTIATE_TEST_SUITE_P(
    AScreenshotOverItsLevel, InputsAndOutputs,
    ::testing::Values(Case{"@ screenshot my.json -o link.png", 2, "link.png: this is my.json"},
                      Case{"@ screenshot pipe -o new.png", 1, "pipe: expected a file, got a pipe"},
                      Case{"@ open pipe", 1, "pipe: expected a file, got a pipe"},
                      Case{"@ open 1-plane pipe.obj", 1, "pipe.obj: expected a file, got a pipe"},
                      Case{"@ open zero", 1, "zero: expected a file, got a device"}),
    named);
#endif

INSTANTIATE_TEST_SUITE_P(
    OutputsThatAreThere, InputsAndOutputs,
    ::testing::Values(
        Case{"@ export my.json -o new.obj -o new.obj", 2, "new.obj: named twice as output"},
        Case{"@ export my.json -o new.obj -o a/../new.obj", 2,
             "a/../new.obj: this is new.obj, which is an output already"},
        Case{"@ export my.json -o new.obj -o dangling.obj", 2, "dangling.obj: this is new.obj"},
        Case{"@ export my.json -o model.obj -o model.stl --no-clobber", 2,
             "model.obj: exists, and --no-clobber"},
        Case{"@ export my.json -o new.obj -o model.stl --no-clobber", 2, "model.stl: exists"},
        Case{"@ deform my.json -o model.obj --no-clobber", 2, "model.obj: exists"},
        Case{"@ render my.json -o link.png --no-clobber --size 32x32", 2, "link.png: "},
        Case{"mkdir l && touch l/3-sphere.png && @ levels -o l --no-clobber",
             2,
             "3-sphere.png: exists",
             {"l", "l/3-sphere.png"}},
        Case{"@ deform my.json -o new.obj --no-clobber", 0, "new.obj: ", {"dangling.obj", "new.obj"}},
        Case{"@ deform my.json -o model.obj", 0, "model.obj: ", {"model.obj"}}),
    named);

INSTANTIATE_TEST_SUITE_P(
    WhatIsNoFile, InputsAndOutputs,
    ::testing::Values(
        Case{"@ check pipe", 1, "pipe: expected a file, got a pipe; name it -"},
        Case{"@ check pipe.json", 1, "pipe.json: expected a file, got a pipe"},
        Case{"@ check pipe.obj", 1, "pipe.obj: expected a file, got a pipe"},
        Case{"@ check pipe-mesh.json", 1, "pipe.obj: expected a file, got a pipe"},
        Case{"bash -c '@ check <(cat my.json)'", 1, "expected a file, got a pipe; name it -"},
        Case{"@ check zero", 1, "zero: expected a file, got a device"},
        Case{"@ check zero.obj", 1, "zero.obj: expected a file, got a device"},
        Case{"@ check a", 1, "expected a file"},
        Case{"@ check folder.obj", 1, "expected a file, got a folder"},
        Case{"@ check empty.json", 1, "empty.json: "},
        Case{"@ check empty.obj", 1, "empty.obj: expected a mesh, got an empty file"},
        Case{"@ match 1-plane pipe.obj", 1, "pipe.obj: expected a file, got a pipe"},
        Case{"@ match zero.json", 1, "zero.json: expected a file, got a device"},
        Case{"@ deform my.json -o pipe.obj", 1, "pipe.obj: cannot write: expected a file, got a pipe"},
        Case{"@ export my.json -o new.pdf -o pipe.obj", 1, "pipe.obj: cannot write: expected a file"},
        Case{"@ deform my.json -o folder.obj", 1, "folder.obj: cannot write: expected a file, got a folder"},
        Case{"@ deform my.json -o zero.obj", 0, "zero.obj: "}),
    named);

INSTANTIATE_TEST_SUITE_P(
    StandardInputAndOutput, InputsAndOutputs,
    ::testing::Values(
        Case{"@ check - <my.json", 0, ""}, Case{"@ check - <model.ply", 0, ""},
        Case{"cat model.stl | @ check -", 0, ""}, Case{"cat level | @ match - --size 32", 0, ""},
        Case{"cat model.stl | @ match my.json - --size 32", 0, ""}, Case{"@ check -", 1, "standard input: "},
        Case{"@ match - - <my.json", 2, "-: expected one file from standard input, got two"},
        Case{"cat my.json | @ render - -o new.png --size 32x32", 0, "new.png: ", {"new.png"}},
        Case{"@ deform my.json -o -", 2, "-: expected --format"},
        Case{"@ deform my.json -o /dev/null", 2, "/dev/null: expected --format"},
        Case{"@ deform my.json -o - --format 3mf", 2,
             "expected an output file that ends in .obj, .stl or .ply"},
        Case{"@ deform my.json -o new.obj --format stl", 2, "--format: "},
        Case{"@ deform my.json -o - --format stl --json", 2, "--json: standard output is taken"},
        Case{"@ deform my.json -o /dev/null --format stl", 0, "/dev/null: "},
        Case{"@ deform my.json -o - --format ply >new.ply", 0, "-: ", {"new.ply"}},
        Case{"@ deform my.json -o - --format ply >/dev/full", 1, "No space left on device"},
        Case{
            "@ export my.json -o - --format pdf -o new.svg >new.pdf", 0, "new.svg: ", {"new.pdf", "new.svg"}},
        Case{"@ render my.json -o - --size 32x32 >new.png", 0, "-: 32 x 32 pixels", {"new.png"}}),
    named);

INSTANTIATE_TEST_SUITE_P(OneOfSeveral, InputsAndOutputs,
                         ::testing::Values(
                             // There is no plate for a sculpture above the mirror.
                             Case{"@ export 3-sphere --base-plate 2 -o new.stl -o picture.png --size 64",
                                  1,
                                  "new.stl: ",
                                  {"picture.png"}},
                             Case{"@ export 3-sphere --base-plate 2 -o new.stl -o picture.png --size 64",
                                  1,
                                  "1 of 2 files could not be written",
                                  {"picture.png"}},
                             Case{"ln -s /dev/full full.stl; @ export my.json -o full.stl -o new.ply",
                                  1,
                                  "full.stl: cannot write: No space left on device",
                                  {"full.stl", "new.ply"}}),
                         named);

using StandardStreams = InputsAndOutputs;

TEST_F(StandardStreams, CarryWholeFiles) {
  ASSERT_EQ(runLine("@ deform my.json -o file.ply && @ deform my.json -o - --format ply >piped.ply").exitCode,
            0);
  EXPECT_EQ(readAll(at("file.ply")), readAll(at("piped.ply")));
  runLine("@ deform my.json -o /dev/stdout --format ply | cat >named.ply");
  EXPECT_EQ(readAll(at("file.ply")), readAll(at("named.ply")));
  const Result check = runLine("@ export my.json -o - --format stl");
  EXPECT_EQ(check.exitCode, 0);
  EXPECT_THAT(check.out, ::testing::Not(HasSubstr("printable"))) << "the mesh alone";
  EXPECT_THAT(check.err, HasSubstr("printable"));
}

TEST_F(StandardStreams, LeaveNothingBehindWhenNobodyReads) {
  fs::create_directory(at("tmp"));
  runLine("TMPDIR=\"$PWD/tmp\" @ deform 1-plane -o - --format obj | head -c 10");
  EXPECT_TRUE(fs::is_empty(at("tmp")));
}

TEST_F(StandardStreams, AFileThatMayNotBeReadIsSaid) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  fs::permissions(at("b.obj"), fs::perms::none);
  EXPECT_THAT(runLine("@ check b.obj").err, HasSubstr("b.obj: cannot open: Permission denied"));
}

}  // namespace
}  // namespace anamorph
