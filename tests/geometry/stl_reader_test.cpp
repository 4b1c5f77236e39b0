#include "geometry/stl_reader.h"

#include <fmt/format.h>
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
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

std::string replaced(const std::string& from, const std::string& to) {
  std::string result = text;
  return result.replace(result.find(from), from.size(), to);
}

struct Damaged {
  std::string bytes;
  std::size_t triangles;  // that are left
  std::vector<std::string> warnings;
};

void expectRead(const Damaged& damaged) {
  MeshRemarks remarks("m.stl");
  Mesh mesh;
  EXPECT_EQ(errorOf([&] { mesh = readStl(damaged.bytes, remarks); }), "no error") << damaged.bytes;
  EXPECT_EQ(mesh.triangles.size(), damaged.triangles) << damaged.bytes;
  std::vector<std::string> warnings;
  for (const std::string& warning : damaged.warnings) warnings.push_back("m.stl: " + warning);
  EXPECT_EQ(remarks.warnings(), warnings) << damaged.bytes;
}

TEST(StlReader, FacetsThatCannotBeUsedAreLeftOut) {
  const std::string numbers = "1 facet with a corner that is not three numbers left out";
  const std::string unread = "1 facet that is not understood left out";
  const std::string unknown = "1 line that is not understood skipped";
  const std::string noEnd = "no endsolid at the end: the file may be cut off";
  const std::string two = text + text;
  const std::string quad = replaced("vertex 0 1.5 0", "vertex 0 1.5 0\n vertex -1 1 0");
  const Damaged cases[] = {
      {replaced("1 0 0", "1 nan 0"), 1, {"line 5: " + numbers}},
      {replaced("1.5", "1e999"), 1, {"line 13: " + numbers}},
      {replaced("1.5", "2e9"), 1, {"line 13: " + numbers}},
      {replaced("1 0 0", "1 0"), 1, {"line 6: " + numbers}},
      {replaced("outer", "inner"), 1, {"line 3: " + unread}},
      {replaced("endfacet\n", ""), 1, {"line 8: " + unread}},
      {replaced("vertex 1 1 0", ""), 1, {"line 8: 1 facet of fewer than three corners left out"}},
      {replaced("endloop", "vertex 1 2 3"), 1, {"line 8: " + unread}},
      {replaced("endsolid", "end"), 2, {"line 16: " + unknown, "line 16: " + noEnd}},
      {replaced("endsolid", "end solid"), 2, {}},
      {replaced("endloop", "end loop"), 2, {}},
      {replaced("endfacet", "End Facet"), 2, {}},
      {replaced("endsolid a name\n", ""), 2, {"line 15: " + noEnd}},
      {replaced("facet normal 0 0 1", "facet"), 2, {}},
      {replaced("facet normal 0 0 1", "facet normal"), 2, {}},
      {text + "rubbish", 2, {"line 17: " + unknown}},
      {replaced(" outer", "# by hand\n outer"), 2, {}},
      {"# by hand\n" + text, 2, {}},
      {quad, 3, {}},
      {replaced("vertex 1 1 0", "vertex 1 1 0\nvertex 0 0 0"), 2, {}},
      {two.substr(0, two.find("endsolid")) + text, 4, {}},
      {"\xEF\xBB\xBF" + text, 2, {}},
      {text + std::string("\0\0\x1a\0", 4), 2, {}},
      {replaced("vertex 0 0 0", "vertex nan nan nan") + text, 3, {"line 4: " + numbers}}};
  for (const Damaged& damaged : cases) expectRead(damaged);
}

TEST(StlReader, TextThatIsCutOffOrHasNothingGoodIsRefused) {
  const std::string one =
      text.substr(0, text.find("facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 1")) + "endsolid";
  const std::string three = "expected three numbers of magnitude at most 1e9, got ";
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string bytes = one;
    return bytes.replace(bytes.find(from), from.size(), to);
  };
  const std::pair<std::string, std::string> cases[] = {
      {with("1 0 0", "1 nan 0"), "line 5: " + three + "\"nan\""},
      {with("1 0 0", "1 0"), "line 6: " + three + "\"vertex\""},
      {with("1 0 0", "1,0 0,0 0,0"),
       "line 5: " + three + "\"1,0\": a decimal comma is not read, write numbers with a point"},
      {with("outer", "inner"), "line 3: expected \"outer\", got \"inner\""},
      {with("vertex 1 1 0", ""), "line 8: expected at least three corners, got 2"},
      {with("1 1 0", "1 0 0"), "triangle 1: expected three different corners"},
      {"solid\n", "line 1: expected \"facet\" or \"endsolid\", got the end of the file"},
      {text.substr(0, text.find("loop")), "line 3: expected \"loop\", got the end of the file"},
      {text.substr(0, text.rfind("1.5")), "line 13: " + three + "the end of the file"},
      {text.substr(0, text.rfind("endfacet")), "line 14: expected \"endfacet\", got the end of the file"}};
  for (const auto& [bytes, message] : cases) EXPECT_EQ(errorOf([&] { read(bytes); }), "m.stl: " + message);
}

TEST(StlReader, TheSizeOfABinaryFileCounts) {
  const auto claims = [](std::uint32_t count) {
    return fmt::format("the head claims {} triangles, the file holds 2, which are read", count);
  };
  const auto skipped = [](int count) {
    return fmt::format("{} bytes after the last triangle skipped", count);
  };
  const std::string good = binary(2, twoTriangles);
  auto infinite = twoTriangles;
  infinite[1][4] = std::numeric_limits<float>::infinity();
  const Damaged cases[] = {
      {binary(1, twoTriangles), 2, {claims(1)}},
      {binary(0, twoTriangles), 2, {claims(0)}},
      {binary(3, twoTriangles), 2, {claims(3)}},
      {binary(0xFFFFFFFF, twoTriangles), 2, {claims(0xFFFFFFFF)}},
      {binary(1, twoTriangles, "solid facet normal"), 2, {claims(1)}},
      {good + std::string(150, '\0'), 2, {}},
      {good + "\n", 2, {}},
      {good + "COLOR=0", 2, {skipped(7)}},
      {good + std::string(60, 'x'), 2, {skipped(60)}},
      {binary(1, twoTriangles) + "COLOR=0", 2, {claims(1), skipped(7)}},
      {binary(2, infinite), 1, {"triangle 2: 1 triangle with a corner that is not three numbers left out"}}};
  for (const Damaged& damaged : cases) expectRead(damaged);
}

TEST(StlReader, BadBinaryIsRefused) {
  auto infinite = twoTriangles, huge = twoTriangles;
  infinite.resize(1);
  infinite[0][4] = std::numeric_limits<float>::infinity();
  huge.resize(1);
  huge[0][0] = 2e9f;
  const std::string three = "expected three numbers of magnitude at most 1e9, got ";
  const std::pair<std::string, std::string> cases[] = {
      {binary(1, infinite), "triangle 1: " + three + "1 inf 0"},
      {binary(1, huge), "triangle 1: " + three + "2000000000 0 0"},
      {binary(2, twoTriangles, "solid").substr(0, 183), "expected 184 bytes for 2 triangles, got 183"},
      {binary(2, {}), "expected 184 bytes for 2 triangles, got 84"},
      {binary(0, {}), "expected at least one triangle, got none and 0 vertices"},
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
