#include "geometry/mesh_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <fstream>

#include "base/file.h"
#include "cannot_run_here.h"
#include "error_text.h"
#include "geometry/awkward_mesh.h"
#include "geometry/shapes.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using testing::makeRandomMesh;

class MeshFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        fs::temp_directory_path() / ("mesh_files_" + std::string(test->name()) + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  static std::string contents(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fs::path folder_;
};

std::vector<std::uint64_t> bitsOf(const Mesh& mesh) {
  std::vector<std::uint64_t> bits;
  for (const auto* axis : {&mesh.positions.x, &mesh.positions.y, &mesh.positions.z}) {
    for (const double value : *axis) bits.push_back(std::bit_cast<std::uint64_t>(value));
  }
  return bits;
}

TEST_F(MeshFiles, ObjAndPlyReadBackToTheSameBits) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937_64 random(seed);
    const Mesh mesh = makeRandomMesh(random);
    for (const char* name : {"mesh.obj", "mesh.ply"}) {
      saveMesh(path(name), mesh, {.scale = 1, .comment = "a comment"});
      const Mesh read = loadMesh(path(name)).mesh;
      ASSERT_EQ(read.triangles, mesh.triangles) << name << ", seed " << seed;
      ASSERT_EQ(bitsOf(read), bitsOf(mesh)) << name << ", seed " << seed;
    }
  }
}

TEST_F(MeshFiles, StlReadsBackToFloatPrecision) {
  for (const Mesh& mesh :
       {makeBox({6, 2, 2}, 8), makeTorusKnot(2, 3, 0.2, 64, 8), makePawn(2, 16), makeSphere(0.1, 9)}) {
    saveMesh(path("mesh.stl"), mesh);
    const Mesh read = loadMesh(path("mesh.stl")).mesh;
    ASSERT_EQ(read.positions.size(), mesh.positions.size());
    ASSERT_EQ(read.triangles.size(), mesh.triangles.size());
    EXPECT_TRUE(isClosed(read));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (int corner = 0; corner < 3; ++corner) {
        const Point is = read.positions[read.triangles[t][corner]],
                    was = mesh.positions[mesh.triangles[t][corner]];
        for (int axis = 0; axis < 3; ++axis)
          EXPECT_EQ(is[axis], static_cast<double>(static_cast<float>(was[axis])));
      }
    }
  }
}

TEST_F(MeshFiles, EveryFormatTakesCapitalEndings) {
  const Mesh cube = makeBox({2, 2, 2}, 1);
  for (const char* name : {"A.OBJ", "a.Stl", "a b.PLY"}) {
    EXPECT_TRUE(isMeshFile(name));
    saveMesh(path(name), cube);
    EXPECT_EQ(loadMesh(path(name)).mesh.triangles.size(), cube.triangles.size()) << name;
  }
}

TEST_F(MeshFiles, ManyRowsStayInOrder) {
  const Mesh fine = makeBox({1, 2, 3}, 210);  // more rows than are formatted at a time
  ASSERT_GT(fine.triangles.size(), 64u * 8192);
  saveMesh(path("fine.obj"), fine);
  EXPECT_TRUE(loadMesh(path("fine.obj")).mesh == fine);
}

TEST_F(MeshFiles, ObjIsWhatPeopleExpect) {
  Mesh mesh;
  for (const Point& p : {Point(0.1, -0.0, 1e-5), {1e9, 2, 1.0 / 3}, {5e-324, 100, -1e20}})
    mesh.positions.push_back(p);
  mesh.triangles = {{0, 1, 2}};
  saveMesh(path("m.obj"), mesh, {.scale = 1, .comment = "made\nby hand"});
  EXPECT_EQ(
      contents(path("m.obj")),
      "# made by hand\nv 0.1 -0 1e-05\nv 1000000000 2 0.3333333333333333\nv 5e-324 100 -1e+20\nf 1 2 3\n");
}

TEST_F(MeshFiles, PlyAndStlHaveTheirHeads) {
  const Mesh cube = makeBox({2, 2, 2}, 1);
  saveMesh(path("m.ply"), cube, {.scale = 1, .comment = "by hand"});
  const std::string ply = contents(path("m.ply"));
  EXPECT_TRUE(ply.starts_with(
      "ply\nformat binary_little_endian 1.0\ncomment by hand\nelement vertex 8\nproperty double x\n"));
  EXPECT_EQ(ply.size(), ply.find("end_header\n") + 11 + 8 * 24 + 12 * 13);
  saveMesh(path("m.stl"), cube, {.scale = 1, .comment = "by hand"});
  const std::string stl = contents(path("m.stl"));
  EXPECT_TRUE(stl.starts_with("binary STL by hand "));
  EXPECT_EQ(stl.size(), 84u + 12 * 50);
}

TEST_F(MeshFiles, ScaleMultipliesPositions) {
  const Mesh cube = makeBox({2, 2, 2}, 1);
  saveMesh(path("m.ply"), cube, {.scale = 12.5, .comment = ""});
  EXPECT_EQ(boundingBox(loadMesh(path("m.ply")).mesh.positions).max, Point(12.5));
}

TEST_F(MeshFiles, MeshesWithoutTrianglesCanBeWrittenButNotRead) {
  Mesh points = makeBox({2, 2, 2}, 1);
  points.triangles.clear();
  for (const char* name : {"p.obj", "p.ply"}) {
    saveMesh(path(name), points);
    EXPECT_EQ(errorOf([&] { loadMesh(path(name)); }),
              path(name) +
                  ": expected at least one triangle, got a point cloud of 8 vertices: it has no surface. "
                  "Make a mesh of it first");
  }
  EXPECT_EQ(errorOf([&] { saveMesh(path("p.stl"), points); }),
            path("p.stl") + ": cannot write: STL needs at least one triangle");
  EXPECT_FALSE(fs::exists(path("p.stl")));
}

TEST_F(MeshFiles, WhatCannotBeWrittenLeavesTheOldFileAlone) {
  Mesh large = makeBox({2, 2, 2}, 1);
  const std::string file = path("m.stl");
  writeFile(file, "old");
  EXPECT_EQ(errorOf([&] { saveMesh(file, large, {.scale = 1e39, .comment = ""}); }),
            file + ": cannot write: STL has no coordinates as large as -1e+39");
  large.positions = mapPoints(large.positions, [](const Point& p) { return 1e308 * p; });
  EXPECT_EQ(errorOf([&] { saveMesh(file, large, {.scale = 10, .comment = ""}); }),
            file + ": cannot write: a scale of 10 is too large");
  EXPECT_EQ(contents(file), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(MeshFiles, AFullDiskIsReported) {
  if (!fs::exists("/dev/full")) return cannotRunHere("no /dev/full");
  fs::create_symlink("/dev/full", path("full.obj"));
  EXPECT_EQ(errorOf([&] {
              saveMesh(path("full.obj"), makeBox({2, 2, 2}, 8));
            }),
            path("full.obj") + ": cannot write: No space left on device");
}

TEST_F(MeshFiles, UnknownEndingsListTheKnownOnes) {
  for (const char* name : {"m.txt", "m", "obj", ".obj", ""}) {
    EXPECT_FALSE(isMeshFile(name));
    EXPECT_FALSE(isModelFile(name));
    const std::string start = *name ? std::string(name) + ": " : "";
    const std::string message = start + "expected a file name that ends in .obj, .stl or .ply";
    EXPECT_EQ(errorOf([&] { loadMesh(name); }), message);
    EXPECT_EQ(errorOf([&] { saveMesh(name, makeBox({2, 2, 2}, 1)); }), message);
  }
}

TEST_F(MeshFiles, FilesThatCannotBeOpened) {
  fs::create_directory(path("folder.obj"));
  EXPECT_EQ(errorOf([&] { loadMesh(path("missing.obj")); }),
            path("missing.obj") + ": cannot open: No such file or directory");
  EXPECT_EQ(errorOf([&] { loadMesh(path("folder.obj")); }),
            path("folder.obj") + ": expected a file, got a folder");
}

TEST_F(MeshFiles, FilesThatMayNotBeRead) {
  writeFile(path("secret.stl"), "solid");
  fs::permissions(path("secret.stl"), fs::perms::none);
  const uid_t self = ::geteuid(), nobody = 65534;
  if (self == 0 && ::seteuid(nobody) != 0) GTEST_SKIP() << "root may read everything here";
  const std::string text = errorOf([&] { loadMesh(path("secret.stl")); });
  ASSERT_EQ(::seteuid(self), 0);
  EXPECT_EQ(text, path("secret.stl") + ": cannot open: Permission denied");
}

TEST_F(MeshFiles, FilesWithNothingInThem) {
  for (const char* name : {"m.obj", "m.stl", "m.ply"}) {
    writeFile(path(name), "");
    EXPECT_EQ(errorOf([&] { loadMesh(path(name)); }), path(name) + ": expected a mesh, got an empty file");
  }
}

TEST_F(MeshFiles, FilesLargerThanTheLimitAreNotRead) {
  writeFile(path("large.obj"), std::string((1 << 20) + 1, '#'));
  EXPECT_EQ(errorOf([&] { loadMesh(path("large.obj"), {.maxBytes = 1 << 20}); }),
            path("large.obj") + ": expected at most 1 MiB, got 2 MiB; --max-mesh-mb raises the limit");
}

TEST_F(MeshFiles, BytesWithoutANameAreKnownByWhatTheyBeginWith) {
  const std::string text =
      "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\nendfacet\nendsolid\n";
  EXPECT_EQ(readMesh(text, "standard input").mesh.triangles.size(), 1u);
  for (const char* name : {"m.obj", "m.stl", "m.ply"}) {
    saveMesh(path(name), readMesh(text, "text.stl").mesh);
    const std::string bytes(readFile(path(name), 1 << 20).view());
    EXPECT_EQ(readMesh(bytes, "standard input").mesh.triangles.size(), 1u) << name;
  }
  EXPECT_EQ(errorOf([] { readMesh("", "standard input"); }),
            "standard input: expected a mesh, got an empty file");
  EXPECT_EQ(errorOf([] { readMesh("{}", "standard input"); }),
            "standard input: expected a file name that ends in .obj, .stl or .ply");
}

TEST_F(MeshFiles, TextThatIsNoMesh) {
  const std::string page = "<!DOCTYPE html>\n<html><body>404 Not Found</body></html>\n";
  EXPECT_EQ(errorOf([&] { readMesh(page, "m.ply"); }),
            "m.ply: this is an HTML page, not a PLY; download the file itself");
  const std::string letter = "Dear all,\nplease find the model attached.\n";
  EXPECT_EQ(errorOf([&] { readMesh(letter, "m.obj"); }),
            "m.obj: expected at least one triangle, got none and 0 vertices");
  EXPECT_EQ(errorOf([&] { readMesh(letter, "m.stl"); }),
            "m.stl: expected an STL file of at least 84 bytes, got 42");
  EXPECT_EQ(errorOf([&] { readMesh(letter, "m.ply"); }),
            "m.ply: line 1: expected \"ply\", got \"Dear all,\"");
}

// Cut off after every byte: an Error or a valid mesh, and for the binary formats an Error, unless whole triangles are
// left of an STL.
TEST_F(MeshFiles, CutOffAnywhere) {
  const Mesh cube = makeBox({2, 2, 2}, 1);
  for (const char* name : {"m.obj", "m.stl", "m.ply"}) {
    saveMesh(path(name), cube);
    const std::string whole = contents(path(name));
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const std::string text = errorOf([&] {
        for (const Triangle& t : readMesh(whole.substr(0, size), name).mesh.triangles) {
          for (const std::uint32_t corner : t) ASSERT_LT(corner, 8u);
        }
      });
      const bool wholeTriangles = name == std::string("m.stl") && size > 84 && (size - 84) % 50 == 0;
      EXPECT_TRUE(text == "no error" ? name == std::string("m.obj") || wholeTriangles
                                     : text.starts_with(name))
          << name << " " << size;
    }
  }
}

}  // namespace
}  // namespace anamorph
