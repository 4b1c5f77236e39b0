#include "geometry/stl_reader.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "error_text.h"
#include "geometry/little_endian_file.h"

namespace anamorph {
namespace {

Mesh read(const std::string& bytes, const MeshLimits& limits = {}) {
  MeshRemarks remarks("m.stl");
  return readStl(bytes, remarks, limits);
}

// Two triangles of a square.
const std::string text =
    "solid a name\n"
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 1 1 0\n endloop\nendfacet\n"
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 1 0\n  vertex 0 1.5 0\n endloop\nendfacet\n"
    "endsolid a name\n";

std::string binary(std::uint32_t count, const std::vector<std::array<float, 9>>& triangles,
                   const std::string& header = "made by hand") {
  std::string bytes = header;
  bytes.resize(80, '\0');
  appendLittleEndian(bytes, count);
  for (const auto& corners : triangles) {
    for (int i = 0; i < 3; ++i)
      appendLittleEndian(bytes, std::numeric_limits<float>::quiet_NaN());  // the normal
    for (const float coordinate : corners) appendLittleEndian(bytes, coordinate);
    appendLittleEndian(bytes, std::uint16_t{7});
  }
  return bytes;
}

const std::vector<std::array<float, 9>> twoTriangles{{0, 0, 0, 1, 0, 0, 1, 1, 0},
                                                     {0, 0, 0, 1, 1, 0, 0, 1.5f, 0}};

Mesh expectedMesh() {
  Mesh mesh;
  for (const Point& p : {Point(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1.5, 0}}) mesh.positions.push_back(p);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(StlReader, TextIsReadAndWelded) {
  EXPECT_EQ(read(text), expectedMesh());
}

TEST(StlReader, BinaryIsReadAndWelded) {
  EXPECT_EQ(read(binary(2, twoTriangles)), expectedMesh());
}

TEST(StlReader, ABinaryFileMayBeginWithSolid) {
  EXPECT_EQ(read(binary(2, twoTriangles, "solid as a rock")), expectedMesh());
}

TEST(StlReader, BytesAfterTheLastTriangleAreSkipped) {
  EXPECT_EQ(read(binary(2, twoTriangles) + "\n"), expectedMesh());
}

TEST(StlReader, BlanksCapitalsAndNamesDoNotMatter) {
  std::string flat = text, capitals = text, windows;
  for (std::size_t i = flat.find('\n') + 1; i < flat.rfind('\n'); ++i) {
    if (flat[i] == '\n') flat[i] = ' ';
  }
  for (char& c : capitals) c = static_cast<char>(std::toupper(c));
  for (const char c : text) c == '\n' ? windows += "\r\n" : windows += c;
  EXPECT_EQ(read(flat), expectedMesh());
  EXPECT_EQ(read(capitals), expectedMesh());
  EXPECT_EQ(read(windows), expectedMesh());
  EXPECT_EQ(read("  \n" + text + " \n\n"), expectedMesh());

  std::string noName = text, oddName = text, nanNormal = text;
  noName.erase(5, 7);
  noName.erase(noName.size() - 8, 7);
  oddName.replace(6, 6, "\xff facet\t");
  nanNormal.replace(nanNormal.find("0 0 1"), 5, "nan nan nan");
  for (const std::string& odd : {noName, oddName, nanNormal}) EXPECT_EQ(read(odd), expectedMesh()) << odd;
}

TEST(StlReader, SeveralSolidsAreOneMesh) {
  EXPECT_EQ(read(text + text).triangles.size(), 4u);
}

TEST(StlReader, TrianglesWithEqualCornersAreDropped) {
  const Mesh mesh = read(binary(3, {twoTriangles[0], {1, 2, 3, 1, 2, 3, 0, 0, 0}, twoTriangles[1]}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 4}}));
}

std::string replaced(const std::string& from, const std::string& to) {
  std::string result = text;
  return result.replace(result.find(from), from.size(), to);
}

TEST(StlReader, BadTextIsNamedByLine) {
  const std::string three = "expected three numbers of magnitude at most 1e9, got ";
  const std::pair<std::string, std::string> cases[] = {
      {replaced("1 0 0", "1 nan 0"), "line 5: " + three + "\"nan\""},
      {replaced("1.5", "1e999"), "line 13: " + three + "\"1e999\""},
      {replaced("1.5", "2e9"), "line 13: " + three + "\"2e9\""},
      {replaced("1 0 0", "1 0"), "line 6: " + three + "\"vertex\""},
      {replaced("outer", "inner"), "line 3: expected \"outer\", got \"inner\""},
      {replaced("vertex 1 1 0", ""), "line 7: expected \"vertex\", got \"endloop\""},
      {replaced("endloop", "vertex 1 2 3"), "line 7: expected \"endloop\", got \"vertex\""},
      {replaced("endsolid", "end"), "line 16: expected \"facet\" or \"endsolid\", got \"end\""},
      {text + "rubbish", "line 17: expected \"solid\", got \"rubbish\""},
      {"solid\n", "line 2: expected \"facet\" or \"endsolid\", got the end of the file"},
      {text.substr(0, text.find("loop")), "line 3: expected \"loop\", got the end of the file"}};
  for (const auto& [bytes, message] : cases) EXPECT_EQ(errorOf([&] { read(bytes); }), "m.stl: " + message);
}

TEST(StlReader, BadBinaryIsNamedByTriangle) {
  auto infinite = twoTriangles, huge = twoTriangles;
  infinite[1][4] = std::numeric_limits<float>::infinity();
  huge[0][0] = 2e9f;
  const std::string three = "expected three numbers of magnitude at most 1e9, got ";
  const std::pair<std::string, std::string> cases[] = {
      {binary(2, infinite), "triangle 2: " + three + "1 inf 0"},
      {binary(2, huge), "triangle 1: " + three + "2000000000 0 0"},
      {binary(3, twoTriangles), "expected 234 bytes for 3 triangles, got 184"},
      {binary(0xFFFFFFFF, twoTriangles), "expected 214748364834 bytes for 4294967295 triangles, got 184"},
      {binary(2, twoTriangles, "solid").substr(0, 183), "expected 184 bytes for 2 triangles, got 183"},
      {binary(0, {}).substr(0, 83), "expected an STL file of at least 84 bytes, got 83"},
      {"hello", "expected an STL file of at least 84 bytes, got 5"}};
  for (const auto& [bytes, message] : cases) EXPECT_EQ(errorOf([&] { read(bytes); }), "m.stl: " + message);
}

TEST(StlReader, LimitsAreNamed) {
  const auto five = std::vector<std::array<float, 9>>(5, twoTriangles[0]);
  std::string fiveInText = "solid\n";
  for (int i = 0; i < 5; ++i) {
    fiveInText += "facet normal 0 0 0 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\n";
  }
  const MeshLimits two{.maxVertices = 2};
  const std::string message = "m.stl: expected at most 4 triangles; --max-vertices raises the limit";
  EXPECT_EQ(errorOf([&] { read(binary(5, five), two); }), message);
  EXPECT_EQ(errorOf([&] { read(fiveInText + "endsolid", two); }), message);
  EXPECT_EQ(errorOf([&] { read(binary(1, {twoTriangles[0]}), two); }),
            "m.stl: expected at most 2 vertices, got 3; --max-vertices raises the limit");
}

}  // namespace
}  // namespace anamorph
