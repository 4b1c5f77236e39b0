// Which way is up: the turns, and the guesses.

#include "geometry/up_guess.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geometry/mesh_files.h"
#include "geometry/shapes.h"

namespace anamorph {
namespace {

TEST(ModelUp, TurnsTheAxisToZWithoutMirroring) {
  const std::vector<std::pair<const char*, Vector>> axes{
      {"z", {0, 0, 1}}, {"y", {0, 1, 0}}, {"-y", {0, -1, 0}}, {"x", {1, 0, 0}}};
  for (const auto& [name, axis] : axes) {
    SCOPED_TRACE(name);
    const auto up = findModelUp(name);
    ASSERT_TRUE(up);
    EXPECT_EQ(std::string(modelUpName(*up)), name);
    EXPECT_EQ(uprightRotation(*up) * axis, Vector(0, 0, 1));
    Mesh mesh;
    mesh.positions.push_back(5.0 * axis);
    EXPECT_EQ(standUp(mesh, *up).positions[0], Point(0, 0, 5));
    const Mesh box = makeBox({1, 2, 3}, 1);
    EXPECT_EQ(signedVolume(standUp(box, *up)), signedVolume(box));
  }
  EXPECT_FALSE(findModelUp("auto"));
  EXPECT_FALSE(findModelUp("Y"));
}

// A house: flat below, with a roof, `height` along one axis.
std::string houseObj(const std::string& comment, bool yUp) {
  std::string text = comment + "\n";
  const auto vertex = [&](double x, double depth, double height) {
    text +=
        yUp ? fmt::format("v {} {} {}\n", x, height, -depth) : fmt::format("v {} {} {}\n", x, depth, height);
  };
  for (const double height : {0, 1}) {
    for (const auto& [x, depth] : {std::pair{0, 0}, {2, 0}, {2, 1}, {0, 1}}) vertex(x, depth, height);
  }
  vertex(1, 0, 1.2);
  vertex(1, 1, 1.2);
  return text + "f 1 4 3 2\nf 1 2 6 9 5\nf 3 4 8 10 7\nf 2 3 7 6\nf 4 1 5 8\nf 6 7 10 9\nf 8 5 9 10\n";
}

UpGuess guessOf(const std::string& text, const std::string& name = "a.obj") {
  return readMesh(text, name).up;
}

TEST(UpGuess, IsByProgramUndersideAndExtent) {
  using Reason = UpGuess::Reason;
  EXPECT_EQ(guessOf(houseObj("# Blender v2.79 (sub 0) OBJ File: ''", false)),
            (UpGuess{ModelUp::y, Reason::program, "Blender"}));
  EXPECT_EQ(
      guessOf(houseObj("# This file uses centimeters as units for non-parametric coordinates.", false)).up,
      ModelUp::y);
  EXPECT_EQ(guessOf(houseObj("# FreeCAD v0.19 build24291", true)),
            (UpGuess{ModelUp::z, Reason::program, "FreeCAD"}));
  EXPECT_EQ(guessOf(houseObj("g Blender", true)).reason, Reason::underside) << "no comment";
  EXPECT_EQ(guessOf(houseObj("# by Mesh Composer", false)).reason, Reason::underside) << "not Poser";
  EXPECT_EQ(guessOf(houseObj("# Poser's own", false)).reason, Reason::program);
  EXPECT_EQ(guessOf(houseObj("# some program", true)), (UpGuess{ModelUp::y, Reason::underside}));
  EXPECT_EQ(guessOf(houseObj("# some program", false)), (UpGuess{ModelUp::z, Reason::underside}));
  // Alike on both sides: higher, lower, as high.
  const auto boxOf = [](const Vector& size) { return guessUp(makeBox(size, 2), MeshFormat::ply, ""); };
  EXPECT_EQ(boxOf({1, 2, 1}), (UpGuess{ModelUp::y, Reason::extent}));
  EXPECT_EQ(boxOf({1, 1, 2}), (UpGuess{ModelUp::z, Reason::extent}));
  EXPECT_EQ(boxOf({3, 1, 1}), (UpGuess{ModelUp::z, Reason::nothing}));
  EXPECT_EQ(guessUp(makeBox({1, 2, 1}, 2), MeshFormat::stl, ""), (UpGuess{ModelUp::z, Reason::printing}));
  // A drawing without depth would lie on the floor, where no eye sees anything of it.
  EXPECT_EQ(guessOf("v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\n").up, ModelUp::y);
  EXPECT_EQ(upGuessText({ModelUp::y, Reason::program, "Blender"}),
            "Its y axis is taken to point up, as Blender writes it.");
}

}  // namespace
}  // namespace anamorph
