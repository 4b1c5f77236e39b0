// Inside-out parts and double triangles, made on purpose.

#include "exports/print_repairs.h"

#include <unistd.h>

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "exports/export_level.h"
#include "exports/printable.h"
#include "finished.h"
#include "geometry/mesh_files.h"
#include "geometry/random_mesh.h"
#include "geometry/shapes.h"

namespace anamorph {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Mesh turned(Mesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

Mesh moved(Mesh mesh, const Vector& way) {
  mesh.positions = mapPoints(mesh.positions, [&](const Point& p) { return p + way; });
  return mesh;
}

Mesh together(const std::vector<Mesh>& meshes) {
  Mesh all;
  for (const Mesh& mesh : meshes) appendMesh(all, mesh);
  return all;
}

const Mesh ball = makeSphere(10, 24), core = makeSphere(4, 16), seed = makeSphere(1, 12);

TEST(PrintRepairs, WhatIsInsideOutIsTurnedAndHollowsStay) {
  struct Case {
    const char* name;
    Mesh mesh, expected;
    std::size_t turnedParts;
  };
  const Mesh beside = moved(ball, {30, 0, 0});
  const std::vector<Case> cases{
      {"sound", ball, ball, 0},
      {"inside out", turned(ball), ball, 1},
      {"a hollow", together({ball, turned(core)}), together({ball, turned(core)}), 0},
      {"inside out with its hollow", together({turned(ball), core}), together({ball, turned(core)}), 2},
      {"a part in a hollow", together({ball, turned(core), seed}), together({ball, turned(core), seed}), 0},
      {"all of that inside out", together({turned(ball), core, turned(seed)}),
       together({ball, turned(core), seed}), 3},
      {"one of two", together({ball, turned(beside)}), together({ball, beside}), 1},
      {"solids in each other", together({ball, core}), together({ball, core}), 0},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const PreparedPrint print = prepareForPrint(c.mesh, true);
    EXPECT_EQ(findRepairs(c.mesh).turnedParts, c.turnedParts);
    EXPECT_EQ(print.notes.size(), c.turnedParts > 0 ? 1u : 0u);
    EXPECT_NEAR(signedVolume(print.mesh), signedVolume(c.expected), 1e-9);
    EXPECT_TRUE(findRepairs(print.mesh).doubled.empty() && findRepairs(print.mesh).turned.empty());
    const PreparedPrint left = prepareForPrint(c.mesh, false);
    EXPECT_EQ(left.mesh, c.mesh) << "with the tolerance off nothing is changed";
    EXPECT_EQ(left.notes.size(), print.notes.size()) << "but it is said";
  }
}

TEST(PrintRepairs, AnOpenPartAndWhatIsInItStayAsTheyAre) {
  Mesh open = ball;
  open.triangles.pop_back();
  for (const Mesh& mesh : {open, turned(open), together({open, turned(core)})}) {
    EXPECT_TRUE(findRepairs(mesh).doubled.empty() && findRepairs(mesh).turned.empty());
  }
}

TEST(PrintRepairs, TrianglesThatAreThereTwiceAreLeftOut) {
  for (std::uint32_t number = 0; number < 20; ++number) {
    SCOPED_TRACE("seed " + std::to_string(number));
    Random random(number);
    Mesh mesh = makeTorusKnot(2, 3, 0.2, 48, 8);
    const Mesh sound = mesh;
    const auto count = static_cast<std::size_t>(random.uniform(1, 40));
    for (std::size_t i = 0; i < count; ++i) {
      Triangle t =
          sound.triangles[static_cast<std::size_t>(random.uniform(0, double(sound.triangles.size()) - 1))];
      std::rotate(t.begin(), t.begin() + static_cast<int>(random.uniform(0, 2.99)), t.end());
      for (std::uint32_t& corner : t) {  // half of them with positions of their own, as of a seam
        if (i % 2 == 0) continue;
        mesh.positions.push_back(mesh.positions[corner]);
        corner = static_cast<std::uint32_t>(mesh.positions.size() - 1);
      }
      mesh.triangles.push_back(t);
    }
    EXPECT_EQ(findRepairs(mesh).doubled.size(), count);
    const PreparedPrint print = prepareForPrint(mesh, true);
    EXPECT_EQ(print.mesh, sound) << "triangles and vertices";
    EXPECT_EQ(print.notes.size(), 1u);
  }
  // The back of a triangle is no second one.
  EXPECT_TRUE(findDoubled({{0, 1, 2}, {0, 2, 1}}).empty());
}

TEST(PrintRepairs, OfTheFieldsFiles) {
  const auto load = [](const std::string& name) {
    return loadMesh(std::string(ANAMORPH_TEST_DATA) + "/field/" + name).mesh;
  };
  EXPECT_THAT(prepareForPrint(load("obj-duplicate-faces/house.obj"), true).notes,
              ElementsAre("16 triangles were there twice and have been left out"));
  EXPECT_THAT(prepareForPrint(load("obj-inside-out/house.obj"), true).notes,
              ElementsAre("1 part was inside out and has been turned"));
  EXPECT_THAT(prepareForPrint(load("obj-hollow/shell.obj"), true).notes, IsEmpty());
}

// Through an export: the file is right, and what was done to it is among its warnings.
TEST(PrintRepairs, AreMadeAndSaidByAnExport) {
  Level level = loadLevel(std::string(ANAMORPH_LEVELS) + "/1-plane.json").level;
  level.original.shape = FileShape{std::string(ANAMORPH_TEST_DATA) + "/field/obj-inside-out/house.obj"};
  ExportRequest request;
  request.path = ::testing::TempDir() + std::to_string(::getpid()) + "repaired.stl";
  for (const double tolerance : {0.25, 0.0}) {
    level.sculpture.tolerancePixels = tolerance;
    const LevelResult finished = testing::finish(level);
    const auto summary = exportLevel(finished, request);
    const double volume = signedVolume(loadMesh(request.path).mesh);
    const auto check = checkSculpture(finished, request);
    ASSERT_EQ(check->notes.size(), 1u);
    EXPECT_THAT(summary->warnings, ElementsAre(check->notes[0]));
    if (tolerance > 0) {
      EXPECT_EQ(check->notes[0], "1 part was inside out and has been turned");
      EXPECT_GT(volume, 0);
      EXPECT_EQ(check->insideOut, 0u);
    } else {
      EXPECT_EQ(check->notes[0], "1 part is inside out, and stays so because the tolerance is off");
      EXPECT_LT(volume, 0);
      EXPECT_EQ(check->insideOut, 1u);
    }
  }
}

}  // namespace
}  // namespace anamorph
