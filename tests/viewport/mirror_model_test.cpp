#include "viewport/mirror_model.h"

#include <string>

#include <gtest/gtest.h>

#include "geometry/normals.h"
#include "geometry/shapes.h"
#include "optics/extrusion.h"
#include "shapes.h"

namespace anamorph {
namespace {

ViewportInput inputWith(const Shape& shape) {
  ViewportInput input;
  input.level.optic = {OpticKind::mirror, shape};
  return input;
}

const Shape ball = meshMirror(withSmoothNormals(makeSphere(2, 48)));

TEST(MirrorModel, IsOnlyThereForShapesWithoutAShader) {
  MirrorModel model;
  EXPECT_EQ(model.at(inputWith(SphereMirror{})).prepared.mesh, nullptr);
  EXPECT_NE(model.at(inputWith(ball)).prepared.mesh, nullptr);
  ViewportInput hidden = inputWith(ball);
  hidden.display.mirror = false;
  EXPECT_EQ(model.at(hidden).prepared.mesh, nullptr);
  hidden = inputWith(ball);
  hidden.level.optic.parts.front().kind = OpticKind::canvas;
  EXPECT_EQ(model.at(hidden).prepared.mesh, nullptr);
  EXPECT_EQ(model.at(inputWith(meshMirror({}))).prepared.mesh, nullptr) << "one with a problem";
}

TEST(MirrorModel, IsMadeOnceAndMovedWithItsTree) {
  MirrorModel model;
  const MirrorTriangles first = model.at(inputWith(ball));
  EXPECT_EQ(model.at(inputWith(ball)).prepared, first.prepared);
  const Shape moved = mapShape(ball, {[](const Point& p) { return p + Vector(0, 0, 3); }});
  const MirrorTriangles second = model.at(inputWith(moved));
  EXPECT_EQ(model.count(), 1) << "no second tree";
  EXPECT_EQ(second.prepared.normalGroups, first.prepared.normalGroups)
      << "and the triangles are not sent again";
  EXPECT_NE(second.prepared.mesh, first.prepared.mesh);
  BvhHit hit;
  ASSERT_TRUE(second.prepared.bvh->closestHit({{0.1, 0.2, 10}, {0, 0, -1}}, hit));
  EXPECT_NEAR(hit.t, 5, 0.02);
  model.at(inputWith(meshMirror(withSmoothNormals(makeSphere(2, 24)))));
  EXPECT_EQ(model.count(), 2);
}

TEST(MirrorModel, IsCutOffAsTheMirrorIs) {
  MirrorModel model;
  Shape half = ball;
  half.clipBy({{{0, 0, 0}, {0, 0, 1}}});
  const PreparedMesh& cut = model.at(inputWith(half)).prepared;
  EXPECT_NEAR(cut.box.min.z, 0, 1e-12);
  EXPECT_NEAR(cut.box.max.z, 2, 1e-12);
}

TEST(MirrorModel, KnowsHowFarItsBorderIs) {
  MirrorModel model;
  const ExtrusionMirror wall;
  Shape half = wall;
  half.clipBy({{{0, 0, 3}, {0, 0, 1}}});
  for (const Shape& shape : {Shape(wall), half}) {
    const MirrorTriangles& made = model.at(inputWith(shape));
    ASSERT_TRUE(made.borders);
    ASSERT_EQ(made.borders->size(), made.prepared.normals->size());
    const Mesh& mesh = *made.prepared.mesh;
    int atTheBorder = 0, inside = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Point corner = mesh.positions[mesh.triangles[t][i]];
        const float border = (*made.borders)[made.prepared.normalGroups->corners[t][i]];
        EXPECT_NEAR(border, Shape(wall)->borderDistance(corner), 1e-6) << corner.x << ", " << corner.z;
        if (corner.z > wall.height - 1e-9) {
          EXPECT_NEAR(border, 0, 1e-6);
        }
        atTheBorder += border < 1e-6f;
        inside += border > 0.1f;
      }
    }
    EXPECT_GT(atTheBorder, 0);
    EXPECT_GT(inside, 0);
  }
  const MirrorTriangles& made = model.at(inputWith(ball));
  for (const float border : *made.borders) EXPECT_EQ(border, 1) << "a mesh has none";
}

}  // namespace
}  // namespace anamorph
