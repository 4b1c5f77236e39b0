// anamorph export, through the program.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/mesh_files.h"
#include "level/json.h"
#include "program.h"
#include "raytrace/png.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;
using ::testing::HasSubstr;

const std::string data = ANAMORPH_TEST_DATA;

TEST(ExportCommand, WritesEveryKindOfFileInOneRun) {
  const TemporaryFolder folder;
  std::string outputs;
  for (const char* name : {"s.stl", "s.ply", "sheet.pdf", "sheet.svg", "match.html", "match.json", "p.png"})
    outputs += " -o " + (folder / name);
  const Result result = run("export 2-cylinder --size 64" + outputs);
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(folder.fileCount(), 7u);
  EXPECT_THAT(result.err, HasSubstr("sheet.pdf: viewing sheet, A4 at 1:1\n"));
  EXPECT_THAT(result.err, HasSubstr("match.html: match report, excellent\n"));
  EXPECT_THAT(result.err, HasSubstr("p.png: 64 x 64 pixels\n"));
  EXPECT_THAT(result.out, HasSubstr("closed              yes\n"));
  EXPECT_THAT(result.out, HasSubstr("printable           yes\n"));
  EXPECT_EQ(loadMesh(folder / "s.stl").mesh.triangles.size(), 12288u);
}

TEST(ExportCommand, ChecksWithoutWriting) {
  const TemporaryFolder folder;
  const Result result = run("export 1-plane --check --json");
  EXPECT_EQ(result.exitCode, 0) << result.err;
  const JsonValue json = parseJson(result.out, "stdout");
  EXPECT_EQ(json.keys, (std::vector<std::string>{"files", "printCheck"}));
  EXPECT_THAT(result.out, HasSubstr("\"printable\": true"));
  EXPECT_THAT(result.out, HasSubstr("\"borderEdges\": 0"));
  const Result text = run("export 1-plane --check --mm-per-unit 20");
  EXPECT_THAT(text.out, HasSubstr("size                120.0 x 40.0 x 40.0 mm\n"));
}

TEST(ExportCommand, ThinWallsAreAFaultOfTheWidthThatIsAskedFor) {
  const Result usual = run("export 2-cylinder --check --json");
  EXPECT_THAT(usual.out, HasSubstr("\"printable\": true"));
  EXPECT_THAT(usual.out, HasSubstr("\"smallestWidthMm\": 0.8"));
  const Result wide = run("export 2-cylinder --check --smallest-width 5");
  EXPECT_THAT(wide.out, HasSubstr("printable           not as it is\n- walls are thinner than the 5 mm"));
  EXPECT_EQ(run("export 2-cylinder --check --smallest-width 0").exitCode, 2);
}

TEST(ExportCommand, PutsRightWhatItMayAndSaysSo) {
  const TemporaryFolder folder;
  const std::string house = data + "/field/obj-duplicate-faces/house.obj";
  const std::string command = "export 1-plane " + house + " -o " + (folder / "s.stl");
  const Result mended = run(command + " --json");
  EXPECT_THAT(mended.out, HasSubstr("were there twice and have been left out"));
  EXPECT_THAT(mended.out, HasSubstr("\"printable\": true"));
  const Result left = run(command + " --json --tolerance off");
  EXPECT_THAT(left.out, HasSubstr("16 triangles are there twice, and stay because the tolerance is off"));
  EXPECT_THAT(left.out, HasSubstr("\"printable\": false"));
  EXPECT_EQ(loadMesh(folder / "s.stl").mesh.triangles.size(), 32u);
}

TEST(ExportCommand, SaysWhatToDoAboutAnOpenSculpture) {
  // The thesis' sphere scene does not show all of a cube ten times as large.
  const TemporaryFolder folder;
  std::string cube = "v -6 -6 -6\nv 6 -6 -6\nv 6 6 -6\nv -6 6 -6\nv -6 -6 6\nv 6 -6 6\nv 6 6 6\nv -6 6 6\n";
  cube += "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  writeText(folder / "cube.obj", cube);
  const Result result =
      run("export " + data + "/scenes/thesis-sphere.json " + (folder / "cube.obj") + " --check");
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("printable           not as it is\n- the surface is open: "));
  EXPECT_THAT(result.out, HasSubstr("of the original did not reach the sculpture"));
}

TEST(ExportCommand, WritesRaysWhenAsked) {
  const TemporaryFolder folder;
  const std::string file = folder / "rays.obj";
  ASSERT_EQ(run("export 2-cylinder --rays vertices:50 -o " + file).exitCode, 0);
  EXPECT_THAT(readAll(file), HasSubstr("# 50 rays, 0 not mapped and left out"));
  ASSERT_EQ(run("export 2-cylinder --rays pixels -o " + file).exitCode, 0);
  EXPECT_THAT(readAll(file), HasSubstr("# rays of the 8 x 8 pixel grid"));
}

TEST(ExportCommand, TellsWrongUsage) {
  const std::pair<const char*, const char*> cases[] = {
      {"export 1", "expected -o FILE, or --check to look at the sculpture only\n"},
      {"export 1 -o a.xyz",
       "a.xyz: expected an output file that ends in .obj, .stl or .ply (sculpture; with "
       "--rays .obj is its rays), .pdf or .svg (viewing sheet), .html or .json (match report) "
       "or .png (picture)\n"},
      {"export 1 -o a.stl --rays pixels", "--rays: expected an output file that ends in .obj\n"},
      {"export 1 -o a.obj --rays vertices:0",
       "--rays: expected vertices, vertices:N with N from 1 to 1000000, or pixels, got vertices:0\n"},
      {"export 1 -o a.obj --rays some",
       "--rays: expected vertices, vertices:N with N from 1 to 1000000, or pixels, got some\n"},
      {"export 1 -o a.pdf --scale 2", "--scale: expected fit or a ratio as 1:2, got 2\n"},
      {"export 1 -o a.pdf --scale 1:0", "--scale: expected fit or a ratio as 1:2, got 1:0\n"},
      {"export 1 -o a.pdf --scale 1:nan", "--scale: expected fit or a ratio as 1:2, got 1:nan\n"},
      {"export 1 -o a.pdf --page A5", "--page: A5 not in {A4,A3,letter} (the option -h explains)\n"},
      {"export 1 -o a.stl --mm-per-unit 0",
       "--mm-per-unit: expected a number from 0.000001 to 1000000, got 0 (the option -h explains)\n"},
      {"export 1 -o a.stl --base-plate 0.1",
       "--base-plate: expected a number from 0.2 to 100, got 0.1 (the option -h explains)\n"},
  };
  for (const auto& [arguments, message] : cases) {
    const Result result = run(arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments;
    EXPECT_EQ(result.err, message) << arguments;
    EXPECT_EQ(result.out, "") << arguments;
  }
}

TEST(ExportCommand, FailsBeforeWritingAnythingAndLeavesOlderFiles) {
  const TemporaryFolder folder;
  writeText(folder / "a.stl", "older");
  const Result noFolder = run("export 2-cylinder -o " + (folder / "a.stl") + " -o " + (folder / "no/b.pdf"));
  EXPECT_EQ(noFolder.exitCode, 1);
  EXPECT_THAT(noFolder.err, HasSubstr("cannot write"));
  EXPECT_EQ(readAll(folder / "a.stl"), "older");
  const Result tooLarge = run("export 2-cylinder --mm-per-unit 100 --scale 1:1 -o " + (folder / "sheet.pdf"));
  EXPECT_EQ(tooLarge.exitCode, 1);
  EXPECT_THAT(tooLarge.err, HasSubstr("choose a smaller scale, larger paper or fewer millimetres per unit"));
  const Result plate = run("export 3-sphere --base-plate 2 -o " + (folder / "a.stl"));
  EXPECT_EQ(plate.exitCode, 1);
  EXPECT_THAT(plate.err, HasSubstr("no base plate can bear this sculpture"));
  EXPECT_EQ(readAll(folder / "a.stl"), "older");
  EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(ExportCommand, ASheetIsMadeWithoutAPlateThatCannotBe) {
  const TemporaryFolder folder;
  const Result result =
      run("export 3-sphere --base-plate 2 -o " + (folder / "a.stl") + " -o " + (folder / "a.svg"));
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("a.stl: no base plate can bear this sculpture"));
  EXPECT_THAT(result.err, HasSubstr("made without the base plate: no base plate can bear this sculpture"));
  EXPECT_THAT(readAll(folder / "a.svg"), HasSubstr("</svg>"));
  EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(ExportCommand, SaysAllOfTheCheckInOneLanguage) {
  const Result result = run("export 2-cylinder --check --language nl");
  EXPECT_EQ(result.exitCode, 0);
  for (const char* line :
       {"te printen          ja\n", "gesloten            ja\n", " mm² van het oppervlak", "; "})
    EXPECT_THAT(result.out, HasSubstr(line));
  EXPECT_THAT(result.out, ::testing::Not(HasSubstr("yes")));
}

}  // namespace
}  // namespace anamorph
