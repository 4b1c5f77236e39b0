#include "viewport/mirror_model.h"

#include <string>

#include <gtest/gtest.h>

#include "geometry/normals.h"
#include "geometry/shapes.h"
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
  const MirrorTriangles& made = model.at(inputWith(ball));
  ASSERT_TRUE(made.borders);
  EXPECT_EQ(made.borders->size(), made.prepared.normals->size());
  for (const float border : *made.borders) EXPECT_EQ(border, 1);
}

}  // namespace
}  // namespace anamorph
