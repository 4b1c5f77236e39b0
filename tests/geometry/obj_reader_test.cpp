#include "geometry/obj_reader.h"

#include <utility>

#include <gtest/gtest.h>

#include "error_text.h"
#include "geometry/polygon.h"

namespace anamorph {
namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Mesh read(const std::string& text, const MeshLimits& limits = {}) {
  MeshRemarks remarks("m.obj");
  return readObj(text, remarks, limits);
}

std::vector<Triangle> trianglesOf(const std::string& faces) {
  return read(square + faces).triangles;
}

TEST(ObjReader, TrianglesQuadsAndPolygons) {
  const std::vector<Triangle> first{{0, 1, 2}};
  EXPECT_EQ(trianglesOf("f 1 2 3\n"), first);
  EXPECT_EQ(trianglesOf("f 1 2 3 4\n"), (std::vector<Triangle>{{0, 1, 2}, {2, 3, 0}}));
  EXPECT_EQ(trianglesOf("f 1 2 3\nf 1 3 4\n"), (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(read("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n").triangles.size(), 3u);
}

TEST(ObjReader, ConcaveQuadsAreCutInside) {
  const Mesh mesh = read("v -1 -1 0\nv 0 0 0\nv 1 -1 0\nv 0 2 0\nf 1 2 3 4\n");
  for (const Triangle& t : mesh.triangles) EXPECT_GT(areaVector(mesh.positions, t).z, 0);
}

TEST(ObjReader, EveryFormOfAFace) {
  const std::vector<Triangle> first{{0, 1, 2}};
  for (const char* face :
       {"f 1 2 3", "f 1/1 2/2 3/3", "f 1/1/1 2/2/2 3/3/3", "f 1//1 2//2 3//3", "f 1/ 2/ 3/", "f -4 -3 -2",
        "f -4/-1/-1 -3/-1/-1 -2/-1/-1", "f 1/99/99 2/99/99 3/99/99", "  \tf\t1  2\t3 \t",
        "f 1 2 3 # a comment", "f 1 2 \\\n3", "f 1 \\\r\n 2 \\\r\n 3\r", "f 01 02 03",
        "s 1\nf 1 2 3\ng a\no b\nusemtl \xff\xfe\nl 1 2\np 1"}) {
    EXPECT_EQ(trianglesOf(face), first) << face;
    EXPECT_EQ(trianglesOf(std::string(face) + "\n"), first) << face;
  }
}

TEST(ObjReader, NegativeIndicesCountFromTheVerticesAbove) {
  const Mesh mesh = read(square + "f -4 -3 -2\n" + square + "f -4 -3 -2\nf 1 -1 -8\nv 9 9 9\n");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_EQ(mesh.positions.size(), 6u);  // of nine
}

TEST(ObjReader, FacesMayComeBeforeTheirVertices) {
  EXPECT_EQ(read("f 1 2 3\n" + square).triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(ObjReader, LineEndsByteOrderMarkAndBlanksDoNotMatter) {
  const Mesh expected = read(square + "f 1 2 -1\n");
  EXPECT_EQ(read("\xEF\xBB\xBF" + square + "f 1 2 -1"), expected);
  for (const std::string end : {"\r\n", "\r", " \t\n", "\n\n", "\n# x\n", "\n   \n"}) {
    std::string text;
    for (const char c : square + "f 1 2 -1\n") c == '\n' ? text += end : text += c;
    EXPECT_EQ(read(text), expected) << end;
  }
}

TEST(ObjReader, WhatFollowsThePositionIsSkipped) {
  const Mesh mesh =
      read("v 1 2 3 1.0\nv\t4\t5\t6 0.1 0.2 0.3\n  v +7 .5 -1e-2 nan\nvn 1 nan 0\nvt inf\nf 1 2 3\n");
  EXPECT_EQ(mesh.positions[0], Point(1, 2, 3));
  EXPECT_EQ(mesh.positions[1], Point(4, 5, 6));
  EXPECT_EQ(mesh.positions[2], Point(7, 0.5, -0.01));
}

TEST(ObjReader, EqualPositionsStay) {
  EXPECT_EQ(read(square + square + "f 1 2 3 4\nf 5 6 7 8\n").positions.size(), 8u);
}

TEST(ObjReader, VerticesThatNoFaceUsesAreLeftOut) {
  MeshRemarks remarks("m.obj");
  const Mesh mesh = readObj("v 1e8 0 0\n" + square + "v 5 5 5\nf 2 3 4\n", remarks);
  EXPECT_EQ(boundingBox(mesh.positions).max, Point(1, 1, 0));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(remarks.warnings(),
            std::vector<std::string>{"m.obj: from vertex 1 on: 3 vertices that no face uses left out"});
}

TEST(ObjReader, CoordinatesAreCorrectlyRounded) {
  const Mesh mesh = read(
      "v 0.1234567890123456 2.2250738585072011e-308 179769313.48623157\n"
      "v 9007199254740993e-16 0.3333333333333333 -7.0385307e-26\nv 5e-324 1e-400 0.1\nf 1 2 3\n");
  EXPECT_EQ(mesh.positions[0], Point(0.1234567890123456, 2.2250738585072011e-308, 179769313.48623157));
  EXPECT_EQ(mesh.positions[1], Point(9007199254740993e-16, 0.3333333333333333, -7.0385307e-26));
  EXPECT_EQ(mesh.positions[2], Point(5e-324, 0, 0.1));
}

TEST(ObjReader, FacesOfFewerThanThreeDifferentCornersGiveNothing) {
  EXPECT_EQ(errorOf([] { trianglesOf("f 1 1 1\n"); }),
            "m.obj: line 5: expected at least three different corners");
  EXPECT_EQ(trianglesOf("f 1 2 2\nf 1 2 2 3\n"), (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(ObjReader, WhatCannotBeUsedIsLeftOutAndSaid) {
  const std::string face = "f 1 2 3\n";
  const std::string indices = "1 face without valid vertex indices left out";
  const std::string shortFace = "1 face of fewer than three corners left out";
  struct Case {
    std::string text;
    std::size_t triangles;
    std::vector<std::string> warnings;
  };
  const Case cases[] = {
      {square + face + "f 1 2\nf 3\nf\nf 1 3 4",
       2,
       {"from line 6 on: 3 faces of fewer than three corners left out"}},
      {square + "f 1 2\n" + face + "f 1 3 4", 2, {"line 5: " + shortFace}},
      {square + face + "f 0 1 2\nf 1 2 -9\n\nf 1 2 99\nf 1 3 4",
       2,
       {"from line 6 on: 3 faces without valid vertex indices left out"}},
      {square + face + "f 1 2 99\nf 1 3 4", 2, {"line 6: " + indices}},
      {square + face + "f 1,2,3\nf 1 2 x\nf 1 2 99999999999\nf 1 3 4",
       2,
       {"from line 6 on: 3 faces that are not understood left out"}},
      {square + "v nan 0 0\nv 1e10 0 0\nv 1,5 0 0\nf 1 2 3 4",
       2,
       {"from line 5 on: 3 vertices without three numbers left out"}},
      {square + "v -nan(ind) 0 0\nf 1 2 3 4\nf 1 2 5\nf 5 2 3 4",
       2,
       {"line 5: 1 vertex without three numbers left out",
        "from line 7 on: 2 faces at an unusable vertex left out"}},
      {square + "f 1 2 3 4\nf 1 1 2\nf 2 2 2 2",
       2,
       {"from line 6 on: 2 faces of fewer than three different corners left out"}},
      {square + "l 1 2\np 3\ncurv 0 1 1 2\ns 1\nsurf 0 1\nf 1 2 3 4",
       2,
       {"from line 5 on: 3 lines, points or curves left out", "line 9: 1 free-form surface left out"}},
      {"v 0 0\nv 1 0 # two\nv 1 1 0\nf 1 2 3",
       1,
       {"from line 1 on: 2 vertices of two numbers, taken to lie at z = 0"}}};
  for (const auto& [text, triangles, expected] : cases) {
    MeshRemarks remarks("m.obj");
    EXPECT_EQ(readObj(text, remarks).triangles.size(), triangles) << text;
    std::vector<std::string> warnings;
    for (const std::string& warning : expected) warnings.push_back("m.obj: " + warning);
    EXPECT_EQ(remarks.warnings(), warnings) << text;
  }
}

TEST(ObjReader, OnlyVerticesAndFacesAreContinued) {
  const std::vector<Triangle> both{{0, 1, 2}, {0, 2, 3}};
  for (const char* before :
       {"usemtl C:\\mats\\", "mtllib a\\", "# a comment \\", "g a\\", "o \\", "vn 0 0 \\"})
    EXPECT_EQ(trianglesOf(std::string(before) + "\nf 1 2 3\nf 1 3 4"), both) << before;
  EXPECT_EQ(trianglesOf("f 1 2 3 \\\nf 1 3 4"), both);
  EXPECT_EQ(trianglesOf("f 1 2 \\ \n3\nf 1 \\\n3 \\\n4"), both);
}

TEST(ObjReader, IndicesAndNumbersAsOtherProgramsWriteThem) {
  const std::vector<Triangle> first{{0, 1, 2}};
  for (const char* face : {"f +1 2 +3", "f 1.0 2. 3.000", "fo 1 2 3", "fo 1/1 \\\n2/2 3/3"})
    EXPECT_EQ(trianglesOf(face), first) << face;
  EXPECT_EQ(read("v 1.5D+01 0 0\nv 0 1d0 0\nv 0 0 1\nf 1 2 3").positions[0], Point(15, 0, 0));
}

TEST(ObjReader, WithoutASurfaceItSaysWhatThereIs) {
  const std::string noSurface = ": it has no surface. Make a mesh of it first";
  EXPECT_EQ(errorOf([] { read(square); }),
            "m.obj: expected at least one triangle, got a point cloud of 4 vertices" + noSurface);
  for (const char* line : {"curv 0 1 1 2 3 4", "l 1 2", "p 1"}) {
    EXPECT_EQ(errorOf([&] { read(square + line); }),
              "m.obj: expected at least one triangle, got lines or curves of 4 vertices" + noSurface);
  }
}

TEST(ObjReader, BadLinesAreNamed) {
  const std::string three = "expected three numbers of magnitude at most 1e9, got ";
  const std::string indices = "expected vertex indices such as 3 or 3/1/2, got ";
  const std::pair<std::string, std::string> cases[] = {
      {"v 1", "line 1: " + three + "\"1\""},
      {"v", "line 1: " + three + "\"\""},
      {"# x\n\nv 1 nan 3", "line 3: " + three + "\"1 nan 3\""},
      {"v 1 2 inf\r\n", "line 1: " + three + "\"1 2 inf\""},
      {"v 1e999 0 0", "line 1: " + three + "\"1e999 0 0\""},
      {"v 1e10 0 0", "line 1: " + three + "\"1e10 0 0\""},
      {"v 1,5 2 3",
       "line 1: " + three + "\"1,5 2 3\": a decimal comma is not read, write numbers with a point"},
      {"v 0x10 2 3", "line 1: " + three + "\"0x10 2 3\""},
      {"v a b c", "line 1: " + three + "\"a b c\""},
      {square + "f 1 2", "line 5: expected at least three corners, got 2"},
      {square + "f", "line 5: expected at least three corners, got 0"},
      {square + "f  \t", "line 5: expected at least three corners, got 0"},
      {square + "f 0 1 2", "line 5: expected vertex indices from 1 on, or negative ones, got 0"},
      {square + "f 1 2 -5", "line 5: expected a vertex above this line, got -5 after 4 vertices"},
      {"f -1 -2 -3", "line 1: expected a vertex above this line, got -1 after 0 vertices"},
      {square + "\nf 1 2 \\\n 5", "line 6: expected vertex indices up to 4, got 5"},
      {square + "f 1 2 999999999", "line 5: expected vertex indices up to 4, got 999999999"},
      {square + "f 1 2 2147483648", "line 5: " + indices + "\"1 2 2147483648\""},
      {square + "f 1 2 4294967299", "line 5: " + indices + "\"1 2 4294967299\""},
      {square + "f 1 2 99999999999999999999", "line 5: " + indices + "\"1 2 99999999999999999999\""},
      {square + "f 1 2 x", "line 5: " + indices + "\"1 2 x\""},
      {square + "f 1 2 3.5", "line 5: " + indices + "\"1 2 3.5\""},
      {square + "f 1 2 nan", "line 5: " + indices + "\"1 2 nan\""},
      {square + "f 1 2 /3", "line 5: expected vertex indices from 1 on, or negative ones, got 0"},
      {square + "f 1 2 -", "line 5: expected vertex indices from 1 on, or negative ones, got 0"},
      {square + "f 1/1/1/1 2 3", "line 5: expected vertex indices from 1 on, or negative ones, got 0"}};
  for (const auto& [text, message] : cases) EXPECT_EQ(errorOf([&] { read(text); }), "m.obj: " + message);
}

TEST(ObjReader, LimitsAreNamed) {
  EXPECT_EQ(errorOf([] { read(square, {.maxVertices = 3}); }),
            "m.obj: line 4: expected at most 3 vertices; --max-vertices raises the limit");
  std::string text = square;
  for (int i = 0; i < 9; ++i) text += "f 1 2 3\n";
  EXPECT_EQ(errorOf([&] { read(text, {.maxVertices = 4}); }),
            "m.obj: line 13: expected at most 8 triangles; --max-vertices raises the limit");
}

TEST(ObjReader, MoreCornersThanAnyPolygonHas) {
  std::string face = "f";
  for (std::size_t i = 0; i <= maxPolygonCorners; ++i) face += " 1";
  EXPECT_EQ(errorOf([&] { read(square + face); }),
            "m.obj: line 5: expected at most 100000 corners, got 100001");
}

struct Smooth {
  SmoothMesh surface;
  std::vector<std::string> warnings;

  Vector normal(std::size_t triangle, std::size_t corner) const {
    return surface.normals[surface.normalsOf(triangle)[corner]];
  }
};

Smooth readSmooth(const std::string& text) {
  MeshRemarks remarks("m.obj");
  SmoothMesh surface = readSmoothObj(text, remarks);
  return {std::move(surface), remarks.warnings()};
}

const std::string fourNormals = "vn 0 0 5\nvn 0 7 0\nvn 0 -1 0\nvn 1e200 0 0\n";

TEST(ObjReader, NormalsAreUnitAndBelongToCorners) {
  const Smooth read = readSmooth(square + fourNormals + "f 1//2 2//1 3//3\nf 1/9/4 3/9/-1 4//-4\n");
  EXPECT_EQ(read.warnings, std::vector<std::string>{});
  EXPECT_EQ(read.normal(0, 0), Vector(0, 1, 0));
  EXPECT_EQ(read.normal(0, 1), Vector(0, 0, 1));
  EXPECT_EQ(read.normal(0, 2), Vector(0, -1, 0));
  EXPECT_EQ(read.normal(1, 0), Vector(1, 0, 0)) << "another one at the same vertex";
  EXPECT_EQ(read.normal(1, 1), Vector(1, 0, 0)) << "the last so far";
  EXPECT_EQ(read.normal(1, 2), Vector(0, 0, 1)) << "the fourth from the end";
}

TEST(ObjReader, NormalsFollowTheCornersOfPolygonsThatAreCut) {
  for (const char* faces : {"f 1//1 2//2 3//3 4//4\n", "f 1//1 2//2 9//2\nf 1//1 2//2 3//3 4//4\n",
                            "f 2//2 2//2 2//3\nf 1//1 2//2 3//3 4//4\n"}) {
    const Smooth read = readSmooth(square + fourNormals + faces);
    ASSERT_EQ(read.surface.mesh.triangles.size(), 2u);
    const Vector expected[] = {{0, 0, 1}, {0, 1, 0}, {0, -1, 0}, {1, 0, 0}};
    for (std::size_t t = 0; t < 2; ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(read.normal(t, i), expected[read.surface.mesh.triangles[t][i]]) << faces;
      }
    }
  }
}

TEST(ObjReader, CornersWithoutANormalHaveThatOfTheirFaces) {
  const std::string bad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 1 0\nvn 0 0 0\nvn a b c\nvn 1 2\nvn nan 0 1\n";
  for (const char* index : {"", "//2", "//3", "//4", "//5", "//99", "//-9", "//0", "/1"}) {
    const Smooth read = readSmooth(bad + "f 1//1 2//1 3" + index + "\n");
    EXPECT_EQ(read.normal(0, 0), Vector(0, 1, 0)) << index;
    EXPECT_EQ(read.normal(0, 2), Vector(0, 0, 1)) << index;
    EXPECT_EQ(read.warnings, std::vector<std::string>{
                                 "m.obj: 1 corner without a normal of its own; it has that of its faces"});
  }
}

TEST(ObjReader, AFileWithoutNormalsHasThoseOfItsFaces) {
  const Smooth read = readSmooth(square + "f 1 2 3 4\n");
  EXPECT_EQ(read.warnings, std::vector<std::string>{});
  for (std::size_t t = 0; t < 2; ++t) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(read.normal(t, i), Vector(0, 0, 1));
  }
}

TEST(ObjReader, OtherReadersOfAFileWithNormalsHaveTheSameMesh) {
  const std::string text = square + fourNormals + "f 1//2 2//1 3//3 4//1\nf 1 2 7\n";
  EXPECT_EQ(readSmooth(text).surface.mesh, read(text));
}

}  // namespace
}  // namespace anamorph
