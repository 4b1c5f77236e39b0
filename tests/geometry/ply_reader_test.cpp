#include "geometry/ply_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "error_text.h"
#include "geometry/little_endian_file.h"

namespace anamorph {
namespace {

Mesh read(const std::string& bytes, const MeshLimits& limits = {}) {
  MeshRemarks remarks("m.ply");
  return readPly(bytes, remarks, limits);
}

std::string head(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\ncomment by hand\nobj_info x\n" + elements + "end_header\n";
}

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string faces = "property list uchar int vertex_indices\n";

std::string textFile(const std::string& rows, int vertices = 4, int faceCount = 1) {
  return head("ascii", "element vertex " + std::to_string(vertices) + "\n" + xyz + "element face " +
                           std::to_string(faceCount) + "\n" + faces) +
         rows;
}

const std::string squareRows = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

Mesh expectedMesh() {
  Mesh mesh;
  for (const Point& p : {Point(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}) mesh.positions.push_back(p);
  mesh.triangles = {{0, 1, 2}, {2, 3, 0}};
  return mesh;
}

TEST(PlyReader, TextWithAQuad) {
  EXPECT_EQ(read(textFile(squareRows + "4 0 1 2 3\n")), expectedMesh());
}

TEST(PlyReader, LineEndsDoNotMatter) {
  std::string windows;
  for (const char c : textFile(squareRows + "4 0 1 2 3\n")) c == '\n' ? windows += "\r\n" : windows += c;
  EXPECT_EQ(read(windows), expectedMesh());
  EXPECT_EQ(read(textFile("0 0 0 1 0 0 1 1 0\n\n0 1 0 4 0 1 2 3")), expectedMesh());
}

// Writes a value in either byte order.
template <typename Number>
void append(std::string& bytes, Number value, bool bigEndian) {
  std::string one;
  appendLittleEndian(one, value);
  if (bigEndian) std::reverse(one.begin(), one.end());
  bytes += one;
}

// Every type, properties in an odd order, extra ones, lists to skip, an unknown element, and faces before
// vertices.
std::string oddFile(bool bigEndian) {
  std::string bytes = head(bigEndian ? "binary_big_endian" : "binary_little_endian",
                           "element face 2\nproperty uchar flags\nproperty list ushort uint vertex_index\n"
                           "property list int double weights\n"
                           "element camera 2\nproperty list char short path\nproperty int8 kind\n"
                           "element nothing 4000000000\n"
                           "element vertex 4\nproperty double z\nproperty uint8 red\nproperty int16 y\n"
                           "property list uint8 float32 normal\nproperty float32 x\n");
  const std::vector<std::vector<std::uint32_t>> polygons{{0, 1, 2}, {2, 3, 0}};
  for (const auto& polygon : polygons) {
    append(bytes, std::uint8_t{9}, bigEndian);
    append(bytes, std::uint16_t{3}, bigEndian);
    for (const std::uint32_t index : polygon) append(bytes, index, bigEndian);
    append(bytes, std::int32_t{1}, bigEndian);
    append(bytes, 0.5, bigEndian);
  }
  for (const std::int8_t length : {0, 2}) {
    append(bytes, length, bigEndian);
    for (int i = 0; i < length; ++i) append(bytes, std::int16_t{-1}, bigEndian);
    append(bytes, std::int8_t{-1}, bigEndian);
  }
  const Mesh mesh = expectedMesh();
  for (std::size_t i = 0; i < 4; ++i) {
    append(bytes, mesh.positions.z[i], bigEndian);
    append(bytes, std::uint8_t{255}, bigEndian);
    append(bytes, static_cast<std::int16_t>(mesh.positions.y[i]), bigEndian);
    append(bytes, std::uint8_t{1}, bigEndian);
    append(bytes, NAN, bigEndian);
    append(bytes, static_cast<float>(mesh.positions.x[i]), bigEndian);
  }
  return bytes;
}

TEST(PlyReader, BinaryOfBothByteOrdersWithMoreThanIsNeeded) {
  EXPECT_EQ(read(oddFile(false)), expectedMesh());
  EXPECT_EQ(read(oddFile(true)), expectedMesh());
}

TEST(PlyReader, ABinaryFileCutOffAnywhereIsRefused) {
  const std::string whole = oddFile(false);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(errorOf([&] { read(whole.substr(0, size)); }), "no error") << size;
  }
}

TEST(PlyReader, TextNumbersAreCorrectlyRoundedAndOthersSkipped) {
  const std::string file = head("ascii", "element vertex 3\nproperty uchar red\n" + xyz +
                                             "property list uchar float extra\nelement face 1\n" + faces) +
                           "x 0.1 -1e-400 5e-324 2 nan inf\n? 1 2 3 0\n0 4 5 6 0\n3 0 1 2\n";
  const Mesh mesh = read(file);
  EXPECT_EQ(mesh.positions[0], Point(0.1, 0, 5e-324));
  EXPECT_EQ(mesh.positions[2], Point(4, 5, 6));
}

TEST(PlyReader, BadHeadsAreNamedByLine) {
  const std::string start = "ply\nformat ascii 1.0\n";
  const std::string typeAndName = "line 4: expected the type and the name of a property, got ";
  const std::pair<std::string, std::string> cases[] = {
      {"plx\n", "line 1: expected \"ply\", got \"plx\""},
      {std::string("\0\0", 2), "line 1: expected \"ply\", got \"\\x00\\x00\""},
      {"ply", "line 1: expected end_header, got the end of the file"},
      {"ply\nend_header\n", "line 2: expected a format line above, got \"end_header\""},
      {"ply\nformat binary 1.0\n",
       "line 2: expected ascii, binary_little_endian or binary_big_endian, and 1.0, got \"format binary "
       "1.0\""},
      {"ply\nformat ascii 2.0\n",
       "line 2: expected ascii, binary_little_endian or binary_big_endian, and 1.0, got \"format ascii "
       "2.0\""},
      {start + "hello\n", "line 3: expected end_header, got the end of the file"},
      {start + "element vertex\n",
       "line 3: expected the name of an element and how many there are, got \"element vertex\""},
      {start + "element vertex -1\n",
       "line 3: expected the name of an element and how many there are, got \"element vertex -1\""},
      {start + "element vertex 99999999999999999999\n",
       "line 3: expected the name of an element and how many there are, got \"element vertex "
       "99999999999999999999\""},
      {start + "element vertex 1\nelement vertex 1\n",
       "line 4: expected each element once, got \"element vertex 1\""},
      {start + "property float x\n",
       "line 3: expected an element before its properties, got \"property float x\""},
      {start + "element vertex 1\nproperty real x\n", typeAndName + "\"property real x\""},
      {start + "element vertex 1\nproperty float\n", typeAndName + "\"property float\""},
      {start + "element face 1\nproperty list real int vertex_indices\n",
       "line 4: expected a type after list, got \"property list real int vertex_indices\""},
      {start + "end_header\n", "expected an element vertex, got none"},
      {start + "element vertex 1\n" + xyz + "end_header\n1 2 3\n",
       "expected at least one triangle, got a point cloud of 1 vertex: it has no surface. Make a mesh of it "
       "first"},
      {head("ascii", "element vertex 6\nelement face 1\n" + faces) + "4 0 1 2 3",
       "expected a property x of element vertex, got none"},
      {head("ascii", "element face 1\n" + faces + "element vertex 6\n") + "4 0 1 2 3",
       "expected a property x of element vertex, got none"},
      {head("ascii", "element vertex 1\n" + xyz + "element face 1\n") + "1 2 3",
       "expected a property list vertex_indices of element face, got none"},
      {head("ascii", "element vertex 0\n" + xyz + "element face 0\n" + faces),
       "expected at least one vertex, got 0"},
      {head("ascii", "element vertex 1\nproperty float x\nproperty float z\nelement face 0\n" + faces) +
           "1 2",
       "expected a property y of element vertex, got none"},
      {head("ascii", "element vertex 1\n" + xyz + "element face 1\nproperty int vertex_indices\n") +
           "1 2 3 4",
       "expected a property list vertex_indices of element face, got none"}};
  for (const auto& [bytes, message] : cases) EXPECT_EQ(errorOf([&] { read(bytes); }), "m.ply: " + message);
}

TEST(PlyReader, BadRowsAreNamed) {
  const std::string three = "expected three numbers of magnitude at most 1e9, got ";
  const std::pair<std::string, std::string> cases[] = {
      {"0 0 0\n1 nan 0\n1 1 0\n0 1 0\n3 0 1 2", "vertex 1: expected a number, got \"nan\""},
      {"0 0 0\n1 0 0\n1 1 0\n0 1e10 0\n3 0 1 3", "vertex 3: " + three + "0 10000000000 0"},
      {"0 0 0\n1 0 0\n1 1 1e999\n0 1 0\n3 0 1 2", "vertex 2: expected a number, got \"1e999\""},
      {squareRows + "2 0 1", "face 0: expected at least three corners, got 2"},
      {squareRows + "100001 0 1", "face 0: expected at most 100000 corners, got 100001"},
      {squareRows + "-3 0 1 2", "face 0: expected the length of a list, got -3"},
      {squareRows + "1e300 0 1 2", "face 0: expected the length of a list, got 1e+300"},
      {squareRows + "3 0 1 4", "face 0: expected vertex indices from 0 to 3, got 4"},
      {squareRows + "3 0 -1 2", "face 0: expected vertex indices from 0 to 3, got -1"},
      {squareRows + "3 0 1.5 2", "face 0: expected vertex indices from 0 to 3, got 1.5"},
      {squareRows + "3 0 1", "face 0: expected a number, got the end of the file"}};
  for (const auto& [rows, message] : cases) {
    EXPECT_EQ(errorOf([&] { read(textFile(rows)); }), "m.ply: " + message);
  }
}

void expectRead(const std::string& bytes, std::size_t triangles, const std::vector<std::string>& expected) {
  MeshRemarks remarks("m.ply");
  Mesh mesh;
  EXPECT_EQ(errorOf([&] { mesh = readPly(bytes, remarks); }), "no error") << bytes;
  EXPECT_EQ(mesh.triangles.size(), triangles) << bytes;
  std::vector<std::string> warnings;
  for (const std::string& warning : expected) warnings.push_back("m.ply: " + warning);
  EXPECT_EQ(remarks.warnings(), warnings) << bytes;
}

TEST(PlyReader, RowsThatCannotBeUsedAreLeftOut) {
  const std::string longer = "1 row longer than the head says, the rest of it skipped";
  const std::string indices = "1 face without valid vertex indices left out";
  expectRead(textFile(squareRows + "3 0 1 2\n3 0 1 4\n3 0 2 3\n", 4, 3), 2, {"face 1: " + indices});
  expectRead(textFile(squareRows + "3 0 1 2\n3 0 1 x\n3 0 2 3\n", 4, 3), 2, {"face 1: " + indices});
  expectRead(textFile(squareRows + "3 0 1 2\n3 0 1\n3 0 2 3\n", 4, 3), 2, {"face 1: " + indices});
  expectRead(textFile(squareRows + "3 0 1 2\n-3 0 1 2\n3 0 2 3\n", 4, 3), 2,
             {"face 1: " + indices, "face 1: " + longer});
  expectRead(textFile(squareRows + "2 0 1\n1 0\n0\n4 0 1 2 3\n", 4, 4), 2,
             {"from face 0 on: 3 faces of fewer than three corners left out"});
  expectRead(textFile(squareRows + "3 0 1 2\n3 0 2 3 255 0 0\n", 4, 2), 2, {"face 1: " + longer});
  expectRead(textFile(squareRows + "3 0 0 2\n4 0 1 2 3\n", 4, 2), 2,
             {"face 0: 1 face of fewer than three different corners left out"});
  expectRead(
      textFile(squareRows + "nan 0 0\n4 0 1 2 3\n3 0 1 4\n", 5, 2), 2,
      {"vertex 4: 1 vertex without three numbers left out", "face 1: 1 face at an unusable vertex left out"});
  expectRead(textFile(squareRows + "7 7\n4 0 1 2 3\n", 5, 1), 2,
             {"vertex 4: 1 vertex without three numbers left out"});
  expectRead(textFile(squareRows + "7 7 7\n4 0 1 2 3\n", 5, 1), 2,
             {"vertex 4: 1 vertex that no face uses left out"});
  expectRead(textFile(squareRows + "4 0 1 2 3\n3 0 1 2\n", 4, 1), 2, {"1 line after the last row skipped"});
}

TEST(PlyReader, CommentsAndBlankLinesMayStandBetweenRows) {
  expectRead(textFile("\n# by hand\n0 0 0\n1 0 0\n\n\ncomment x\n1 1 0\n0 1 0\n4 0 1 2 3\n\n"), 2, {});
}

TEST(PlyReader, ARowMaySpreadOverLines) {
  expectRead(textFile("0\n0\n0\n1\n0\n0\n1\n1\n0\n0\n1\n0\n4\n0\n1\n2\n3\n"), 2, {});
  expectRead(textFile(squareRows + "4 0 1\n2 3\n"), 2, {});
}

TEST(PlyReader, ListsThatRowsDoNotHaveAreEmpty) {
  const std::string start =
      head("ascii", "element vertex 4\n" + xyz + "property list uchar int tags\nelement face 1\n" + faces);
  expectRead(start + "0 0 0\n1 0 0 0\n1 1 0 2 5 6\n0 1 0\n4 0 1 2 3\n", 2, {});
}

TEST(PlyReader, HeadsAsOtherProgramsWriteThem) {
  const std::string plain = textFile(squareRows + "4 0 1 2 3\n");
  const std::string skipped = "line 2: 1 unknown line of the head skipped";
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string bytes = plain;
    return bytes.replace(bytes.find(from), from.size(), to);
  };
  expectRead("\xEF\xBB\xBF" + plain, 2, {});
  expectRead("\n \r\n" + plain, 2, {});
  expectRead(with("ply\n", "ply\nCreated by hand\n"), 2, {skipped});
  expectRead(with("ply\n", "ply\ncrs {\"authid\":\"EPSG:2056\"}\n"), 2, {skipped});
  expectRead(with("list uchar", "list float"), 2, {});
  std::string returns = plain;
  std::replace(returns.begin(), returns.end(), '\n', '\r');
  expectRead(returns, 2, {});
  expectRead(plain + std::string("\0\0\x1a\0", 4), 2, {});
}

TEST(PlyReader, ABinaryFileMayHaveAHeadOfReturns) {
  for (const float first : {0.0f, 2.4e-38f}) {  // whose first byte may be \n
    std::string bytes = head("binary_little_endian", "element vertex 3\n" + xyz + "element face 1\n" + faces);
    std::replace(bytes.begin(), bytes.end(), '\n', '\r');
    std::string data;
    for (const float value : {first, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f})
      append(data, value, false);
    data[0] = first > 0 ? '\n' : '\0';
    append(data, std::uint8_t{3}, false);
    for (const int index : {0, 1, 2}) append(data, index, false);
    expectRead(bytes + data, 1, {});
    expectRead(bytes + data + "more", 1, {"4 bytes after the last row skipped"});
  }
}

TEST(PlyReader, StripsAreTriangles) {
  const auto strips = [](const std::string& rows, int count) {
    return head("ascii", "element vertex 4\n" + xyz + "element tristrips " + std::to_string(count) +
                             "\nproperty list int int vertex_indices\n") +
           squareRows + rows;
  };
  EXPECT_EQ(read(strips("4 0 1 2 3\n", 1)).triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(read(strips("8 0 1 2 -1 0 2 3 -1\n", 1)).triangles,
            (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  expectRead(strips("5 0 1 1 2 3\n", 1), 1, {"vertex 0: 1 vertex that no face uses left out"});
  expectRead(strips("4 0 1 2 3\n3 0 1 9\n", 2), 2,
             {"tristrips 1: 1 triangle of a strip with an index that no vertex has left out"});
  expectRead(strips("4 0 1 2 3\n9 0 1\n3 0 2 3\n", 3), 3, {"tristrips 1: 1 strip shorter than it says"});
}

TEST(PlyReader, SplatsHaveNoSurface) {
  EXPECT_EQ(errorOf([] {
              read(head("ascii", "element vertex 1\n" + xyz + "property float f_dc_0\n") + "0 0 0 1\n");
            }),
            "m.ply: expected at least one triangle, got Gaussian splats, a point cloud of 1 vertex: it has "
            "no surface. "
            "Make a mesh of it first");
}

TEST(PlyReader, HugeNumbersOfRowsAreRefusedBeforeMemoryIsTaken) {
  const auto file = [](const std::string& format, const std::string& vertices, const std::string& count) {
    return head(format, "element vertex " + vertices + "\n" + xyz + "element face " + count + "\n" + faces) +
           "1 2 3";
  };
  EXPECT_EQ(errorOf([&] { read(file("ascii", "4000000000", "1")); }),
            "m.ply: expected at most 50000000 vertices, got 4000000000; --max-vertices raises the limit");
  EXPECT_EQ(errorOf([&] { read(file("ascii", "1", "4000000000")); }),
            "m.ply: expected at most 100000000 faces, got 4000000000; --max-vertices raises the limit");
  EXPECT_EQ(errorOf([&] { read(file("ascii", "40000000", "1")); }),
            "m.ply: expected 40000000 rows of element \"vertex\", got the end of the file after at most 1");
  EXPECT_EQ(errorOf([&] { read(file("binary_big_endian", "40000000", "1")); }),
            "m.ply: expected 40000000 rows of element \"vertex\", got the end of the file after at most 0");
  const std::string other = "element other 4000000000\nproperty char a\n";
  EXPECT_EQ(
      errorOf([&] {
        read(head("ascii", "element vertex 1\n" + xyz + "element face 0\n" + faces + other) + "1 2 3 4 5");
      }),
      "m.ply: expected 4000000000 rows of element \"other\", got the end of the file after at most 2");
}

TEST(PlyReader, LimitsAreNamed) {
  EXPECT_EQ(errorOf([] { read(textFile(squareRows + "3 0 1 2"), {.maxVertices = 3}); }),
            "m.ply: expected at most 3 vertices, got 4; --max-vertices raises the limit");
  const std::string manyCorners = "10 0 1 2 3 0 1 2 3 0 1\n10 0 1 2 3 0 1 2 3 0 1\n";
  EXPECT_EQ(errorOf([&] { read(textFile(squareRows + manyCorners, 4, 2), {.maxVertices = 4}); }),
            "m.ply: face 1: expected at most 8 triangles; --max-vertices raises the limit");
}

}  // namespace
}  // namespace anamorph
