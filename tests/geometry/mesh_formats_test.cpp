#include "geometry/mesh_formats.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/file.h"
#include "error_text.h"
#include "geometry/mesh_files.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

const std::string triangleObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string triangleStl =
    "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
    "0\nendloop\nendfacet\nendsolid\n";
const std::string trianglePly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement "
    "face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

TEST(MeshFormats, ContentCountsAndAWrongEndingIsSaid) {
  const std::pair<std::string, std::string> files[] = {
      {"m.obj", triangleObj}, {"m.stl", triangleStl}, {"m.ply", trianglePly}};
  for (const auto& [right, bytes] : files) {
    for (const std::string name : {"m.obj", "m.stl", "m.ply", "m.txt", "m"}) {
      const LoadedMesh loaded = readMesh(bytes, name);
      EXPECT_EQ(loaded.mesh.triangles.size(), 1u) << right << " as " << name;
      const bool isWrong = name != right && isMeshFile(name);
      EXPECT_EQ(loaded.warnings.size(), isWrong ? 1u : 0u) << right << " as " << name;
    }
  }
  EXPECT_EQ(readMesh(triangleObj, "m.stl").warnings,
            std::vector<std::string>{"m.stl: this is an OBJ, not an STL; read as what it is"});
}

TEST(MeshFormats, ContentIsKnownByItsBeginning) {
  using enum MeshFormat;
  const std::string longComment(100'000, '#');
  const std::pair<std::string, std::optional<MeshFormat>> cases[] = {
      {"# by hand\n\nmtllib a.mtl\no a\nv 1 2 3\n", obj},
      {"\xEF\xBB\xBFv 1 2 3", obj},
      {"g x\r\rv 1 2 3\r", obj},
      {"vertex 1 2 3", std::nullopt},
      {"v one two", std::nullopt},
      {"g x\n", std::nullopt},
      {longComment + "\nv 1 2 3\n", std::nullopt},
      {"Solid x\n facet", stl},
      {"solid x\n", std::nullopt},
      {"\n ply\nformat ascii 1.0\n", ply},
      {"ply", std::nullopt},
      {"", std::nullopt}};
  for (const auto& [bytes, format] : cases)
    EXPECT_EQ(formatByContent(bytes, bytes.size()), format) << bytes.substr(0, 100);
}

TEST(MeshFormats, OtherFormatsAreNamedWithTheWayOut) {
  const std::pair<std::string, std::string> byEnding[] = {
      {"m.step", "STEP is not read; export it as STL or OBJ"},
      {"m.STP", "STEP is not read; export it as STL or OBJ"},
      {"m.3mf", "3MF is not read; export it as STL or OBJ"},
      {"m.blend", "Blender is not read; export it as STL or OBJ"},
      {"m.obj.gz", "gzip is not read; unpack it first"},
      {"m.xyz", "a point cloud is not read; it has no surface. Make a mesh of it first"},
      {"m.png", "PNG is not read; a mesh is needed: STL, OBJ or PLY"}};
  for (const auto& [name, message] : byEnding) {
    EXPECT_EQ(errorOf([&] { loadMesh(name); }), name + ": " + message);
    EXPECT_TRUE(isModelFile(name)) << name;
    EXPECT_FALSE(isMeshFile(name)) << name;
  }
  const std::pair<std::string, std::string> byContent[] = {
      {"ISO-10303-21;\nHEADER;", "this is a STEP file, not an STL; export it as STL or OBJ"},
      {"\n <!DOCTYPE HTML>\n<html>", "this is an HTML page, not an STL; download the file itself"},
      {"<!-- saved -->\n<HTML>", "this is an HTML page, not an STL; download the file itself"},
      {"<?xml version=\"1.0\"?>\n<COLLADA>", "this is a COLLADA file, not an STL; export it as STL or OBJ"},
      {"%PDF-1.4\n" + triangleStl, "this is a PDF, not an STL; a mesh is needed: STL, OBJ or PLY"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 3\n",
       "this is a Git LFS pointer, not an STL; get the file itself with: git lfs pull"},
      {std::string("\xFF\xFEs\0o\0", 6), "this is text in UTF-16, not an STL; save it as UTF-8"},
      {std::string("s\0o\0l\0i\0d\0 \0h\0o\0u\0s\0e\0", 22),
       "this is text in UTF-16, not an STL; save it as UTF-8"},
      {"PK\x03\x04", "this is a ZIP archive, not an STL; unpack it first"},
      {"glTF\x02", "this is a glTF file, not an STL; export it as STL or OBJ"}};
  for (const auto& [bytes, message] : byContent)
    EXPECT_EQ(errorOf([&] { readMesh(bytes, "m.stl"); }), "m.stl: " + message);
}

// A name in the head of a binary STL is no beginning of another format.
TEST(MeshFormats, ABinaryStlMayBeginWithAnything) {
  for (const std::string head : {"PK\x03\x04", "%PDF", "OFF road", "solid", "v 1 2 3", "<html>"}) {
    std::string bytes = head;
    bytes.resize(84 + 50, '\0');
    bytes[80] = 1;
    bytes[84 + 12 + 12 + 3] = bytes[84 + 12 + 24 + 7] = 0x3f;
    EXPECT_EQ(readMesh(bytes, "m.stl").mesh.triangles.size(), 1u) << head;
  }
}

TEST(MeshFormats, FilesWithoutAnEndingAreLookedInto) {
  const fs::path folder = fs::temp_directory_path() / ("mesh_formats_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const std::pair<std::string, bool> cases[] = {{triangleObj, true},
                                                {"ISO-10303-21;", true},
                                                {"{\"Eye\": [0, 0, 0]}", false},
                                                {"words", false},
                                                {"", false}};
  for (const auto& [bytes, isModel] : cases) {
    writeFile(folder / "file", bytes);
    EXPECT_EQ(isModelFile(folder / "file"), isModel) << bytes;
  }
  writeFile(folder / "file", triangleObj);
  EXPECT_EQ(loadMesh(folder / "file").mesh.triangles.size(), 1u);
  writeFile(folder / "file", "ISO-10303-21;");
  EXPECT_EQ(errorOf([&] { loadMesh(folder / "file"); }),
            (folder / "file").string() + ": STEP is not read; export it as STL or OBJ");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace anamorph
