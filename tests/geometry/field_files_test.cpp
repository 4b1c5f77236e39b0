// Small files of the kinds that programs write and people have trouble with (tests/data/field). The house is a closed
// solid of 10 vertices and 16 triangles, 2 x 1 x 1.8.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "base/file.h"
#include "error_text.h"
#include "geometry/mesh_files.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(ANAMORPH_TEST_DATA) / "field";

struct OpenedFile {
  std::string name;
  std::vector<std::string> warnings = {};
  std::size_t triangles = 16;
  std::string size = "2 x 1 x 1.8";
};

const std::string badIndex = "1 face without valid vertex indices left out";

const std::vector<OpenedFile> openedFiles{
    {"obj-2d-vertices/flat.obj",
     {"from line 1 on: 3 vertices of two numbers, taken to lie at z = 0"},
     1,
     "1 x 1 x 0"},
    {"obj-bom/house.obj"},
    {"obj-bowtie/bow.obj", {}, 2, "2 x 0 x 2"},
    {"obj-continuation/house.obj"},
    {"obj-cr-only/house.obj"},
    {"obj-crlf-mixed/house.obj"},
    {"obj-degenerate/house.obj", {"from line 18 on: 3 faces of fewer than three different corners left out"}},
    {"obj-duplicate-faces/house.obj", {}, 32},
    {"obj-face-before-vertices/house.obj"},
    {"obj-face-of-one/house.obj",
     {"line 11: 1 line, point or curve left out",
      "from line 12 on: 2 faces of fewer than three corners left out"}},
    {"obj-face-of-two/house.obj", {"line 18: 1 face of fewer than three corners left out"}},
    {"obj-flat-on-floor/sheet.obj", {}, 2, "2 x 1 x 0"},
    {"obj-float-index/house.obj"},
    {"obj-fo-keyword/house.obj"},
    {"obj-fortran-exponent/house.obj"},
    {"obj-geo-utm/house.obj"},
    {"obj-hollow/shell.obj", {}, 32},
    {"obj-index-beyond/house.obj", {"line 11: " + badIndex}, 14},
    {"obj-inside-out/house.obj"},
    {"obj-mesh-and-curve/house.obj", {"line 13: 1 line, point or curve left out"}},
    {"obj-nan-unused-vertex/house.obj", {"line 11: 1 vertex without three numbers left out"}},
    {"obj-needle-triangles/strip.obj", {}, 1001, "1 x 1 x 0.5"},
    {"obj-needle/needle.obj", {}, 1, "2 x 0 x 0"},
    {"obj-ngon-with-slit/plate.obj", {}, 8, "4 x 0 x 4"},
    {"obj-no-trailing-newline/house.obj"},
    {"obj-nonmanifold-edge/two.obj", {}, 5, "1 x 2 x 1"},
    {"obj-nonplanar-ngon/saddle.obj", {}, 2, "2 x 2 x 1"},
    {"obj-normals-not-there/house.obj"},
    {"obj-pinched-vertex/two.obj", {}, 32, "4 x 2 x 3.6"},
    {"obj-plus-index/house.obj"},
    {"obj-quotes-comma-f/house.obj", {"line 11: 1 face that is not understood left out"}, 14},
    {"obj-reversed-twin/house.obj", {}, 32},
    {"obj-seams-unwelded/house.obj"},
    {"obj-self-intersecting/two.obj", {}, 32, "2.5 x 1.3 x 2"},
    {"obj-slash-at-end/house.obj"},
    {"obj-stray-vertex-far/house.obj", {"vertex 11: 1 vertex that no face uses left out"}},
    {"obj-tab-separated/house.obj"},
    {"obj-tiny-1e-30/house.obj", {}, 16, "2e-30 x 1e-30 x 1.8e-30"},
    {"obj-tiny/house.obj", {}, 16, "2e-05 x 1e-05 x 1.8e-05"},
    {"obj-usemtl-ends-in-backslash/house.obj"},
    {"obj-vertex-colors-0-255/house.obj"},
    {"obj-windows-mtl-path/house.obj"},
    {"obj-y-up/house.obj", {}, 16, "2 x 1.8 x 1"},
    {"obj-zbrush-mrgb/house.obj"},
    {"obj-zero-index/house.obj", {"line 11: " + badIndex}, 14},
    {"obj-zero-thickness/sheet.obj", {}, 2, "2 x 0 x 1"},
    {"ply-ascii-row-longer/house.ply", {"face 1: 1 row longer than the head says, the rest of it skipped"}},
    {"ply-big-endian/house.ply"},
    {"ply-blank-lines/house.ply"},
    {"ply-bom/house.ply"},
    {"ply-comment-between/house.ply"},
    {"ply-comment-keyword-lost/house.ply", {"line 3: 1 unknown line of the head skipped"}},
    {"ply-cr-header-binary-rhino/house.ply"},
    {"ply-crlf-header-binary/house.ply"},
    {"ply-face-minus1/house.ply", {"face 7: " + badIndex}},
    {"ply-faces-first/house.ply"},
    {"ply-float-count/house.ply"},
    {"ply-float-index/house.ply"},
    {"ply-format-after-element/house.ply"},
    {"ply-nan-vertex/house.ply",
     {"vertex 10: 1 vertex without three numbers left out", "face 7: 1 face at an unusable vertex left out"}},
    {"ply-obj-info/house.ply"},
    {"ply-qgis-crs-line/house.ply", {"line 3: 1 unknown line of the head skipped"}},
    {"ply-row-on-several-lines/house.ply"},
    {"ply-spec-crlf-ascii/house.ply"},
    {"ply-trailing-bytes/house.ply"},
    {"ply-tristrips-ascii/strips.ply", {}, 2, "1 x 0 x 1"},
    {"ply-ushort-list/house.ply"},
    {"ply-vertex-list-prop/house.ply"},
    {"stl-attr-payload/house.stl"},
    {"stl-binary-count-low/house.stl", {"the head claims 3 triangles, the file holds 16, which are read"}},
    {"stl-binary-solid-facet/house.stl"},
    {"stl-binary-solid/house.stl"},
    {"stl-binary-trailing/house.stl"},
    {"stl-bom/house.stl"},
    {"stl-capital-E/house.stl"},
    {"stl-cr-only/house.stl"},
    {"stl-end-solid-two-words/house.stl"},
    {"stl-exponents-3digits/house.stl"},
    {"stl-name-cjk/house.stl"},
    {"stl-name-latin1/house.stl"},
    {"stl-no-endsolid/house.stl", {"line 113: no endsolid at the end: the file may be cut off"}},
    {"stl-no-name/house.stl"},
    {"stl-nul-padded/house.stl"},
    {"stl-one-nan-facet/house.stl", {"line 116: 1 facet with a corner that is not three numbers left out"}},
    {"stl-quad-facets/house.stl"},
    {"stl-single-facet/tri.stl", {}, 1, "2 x 0 x 1"},
    {"stl-solid-name-facet/house.stl"},
    {"stl-space-first/house.stl", {}, 32, "5 x 1 x 1.8"},
    {"stl-uppercase/house.stl"},
    {"formats/noending"}};

struct RefusedFile {
  std::string name, message;
};

const std::string comma = ": a decimal comma is not read, write numbers with a point";
const std::string three = "expected three numbers of magnitude at most 1e9, got ";
const std::string noSurface = ": it has no surface. Make a mesh of it first";

const std::vector<RefusedFile> refusedFiles{
    {"obj-comma-decimals/house.obj", "line 1: " + three + "\"0,000 0,000 0,000\"" + comma},
    {"obj-curves-only/curve.obj",
     "expected at least one triangle, got lines or curves of 4 vertices" + noSurface},
    {"ply-double-count-short/house.ply", "face 7: expected a number, got the end of the file"},
    {"ply-face-count-one-too-many/house.ply", "face 7: expected a number, got the end of the file"},
    {"ply-points-3dgs/splat.ply",
     "expected at least one triangle, got Gaussian splats, a point cloud of 2 vertices" + noSurface},
    {"stl-comma-decimals/house.stl", "line 4: " + three + "\"0,000\"" + comma},
    {"stl-cut-in-facet/house.stl", "line 110: expected \"endfacet\", got the end of the file"},
    {"stl-html/house.stl", "this is an HTML page, not an STL; download the file itself"},
    {"stl-pdf-first/house.stl", "this is a PDF, not an STL; a mesh is needed: STL, OBJ or PLY"},
    {"stl-utf16/house.stl", "this is text in UTF-16, not an STL; save it as UTF-8"},
    {"formats/m.3mf", "3MF is not read; export it as STL or OBJ"},
    {"formats/m.blend", "Blender is not read; export it as STL or OBJ"},
    {"formats/m.dxf", "DXF is not read; export it as STL or OBJ"},
    {"formats/m.fbx", "FBX is not read; export it as STL or OBJ"},
    {"formats/m.glb", "glTF is not read; export it as STL or OBJ"},
    {"formats/m.gltf", "glTF is not read; export it as STL or OBJ"},
    {"formats/m.obj.gz", "gzip is not read; unpack it first"},
    {"formats/m.off", "OFF is not read; export it as STL or OBJ"},
    {"formats/m.png", "PNG is not read; a mesh is needed: STL, OBJ or PLY"},
    {"formats/m.step", "STEP is not read; export it as STL or OBJ"},
    {"formats/m.svg", "SVG is not read; a mesh is needed: STL, OBJ or PLY"},
    {"formats/m.zip", "ZIP is not read; unpack it first"}};

TEST(FieldFiles, AreOpenedWithTheirWarnings) {
  for (const OpenedFile& file : openedFiles) {
    const std::string path = (folder / file.name).string();
    LoadedMesh loaded;
    EXPECT_EQ(errorOf([&] { loaded = loadMesh(path); }), "no error");
    EXPECT_EQ(loaded.mesh.triangles.size(), file.triangles) << file.name;
    const Vector size = boundingBox(loaded.mesh.positions).size();
    EXPECT_EQ(fmt::format("{:.6g} x {:.6g} x {:.6g}", size.x, size.y, size.z), file.size) << file.name;
    std::vector<std::string> warnings;
    for (const std::string& warning : file.warnings) warnings.push_back(path + ": " + warning);
    EXPECT_EQ(loaded.warnings, warnings) << file.name;
  }
}

TEST(FieldFiles, AreRefusedWithTheReason) {
  for (const auto& [name, message] : refusedFiles) {
    const std::string path = (folder / name).string();
    EXPECT_EQ(errorOf([&] { loadMesh(path); }), path + ": " + message);
  }
}

TEST(FieldFiles, AreAllHere) {
  std::set<std::string> named, found;
  for (const OpenedFile& file : openedFiles) named.insert(file.name);
  for (const RefusedFile& file : refusedFiles) named.insert(file.name);
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) found.insert(entry.path().lexically_relative(folder).generic_string());
  }
  EXPECT_EQ(named, found);
}

TEST(FieldFiles, NamesDoNotMatter) {
  const fs::path own = fs::temp_directory_path() / ("field_names_" + std::to_string(::getpid()));
  fs::create_directories(own);
  const FileBytes house = readFile(folder / "obj-tab-separated/house.obj", 1 << 20);
  for (const char* name :
       {"#hash.obj", "-minus.obj", "100%.obj", "Größe-Übung.obj", "haus mit leerzeichen.obj", "quote's.obj",
        "tab\tname.obj", "two.dots.v2.obj", "émoji-🐇.obj", "模型.obj", "HOUSE.OBJ"}) {
    writeFile(own / name, house.view());
    EXPECT_EQ(loadMesh(own / name).mesh.triangles.size(), 16u) << name;
    EXPECT_TRUE(isModelFile(own / name)) << name;
  }
  fs::remove_all(own);
}

}  // namespace
}  // namespace anamorph
