#include "raytrace/scene.h"

#include <gtest/gtest.h>

#include "base/check.h"
#include "raytrace/scene_hit.h"
#include "raytrace/test_scenes.h"
#include "shapes.h"

namespace anamorph::test {
namespace {

TEST(SceneInput, IsComparedByValueAndByPointer) {
  const SceneInput a = makeStudio();
  SceneInput b = a;
  EXPECT_EQ(a, b);
  b.lights[0].intensity += 0.1;
  EXPECT_NE(a, b);
  EXPECT_NE(a, makeStudio()) << "equal meshes of their own count as different";
}

TEST(BuildScene, MeasuresSurfacesAndOptic) {
  SceneInput input;
  input.surfaces.push_back(makeSurface("box", makeCuboid({0, 0, 0}, {2, 4, 4}), {}));
  const RenderScene small = buildScene(input);
  EXPECT_EQ(small.centre, Point(1, 2, 2));
  EXPECT_DOUBLE_EQ(small.radius, 3);
  input.optic = makeMirror(SphereMirror{{-10, 0, 0}, 1});
  EXPECT_GT(buildScene(input).radius, 6);
  EXPECT_LT(buildScene(input).centre.x, 0);
}

TEST(BuildScene, AnEmptySceneHasASize) {
  const RenderScene scene = buildScene({});
  EXPECT_GT(scene.radius, 0);
  EXPECT_GT(scene.epsilon, 0);
}

TEST(BuildScene, SurfacesMustBeComplete) {
  SceneInput input;
  input.surfaces.push_back(makeSurface("box", makeFloor(1, 0), {}));
  input.surfaces[0].bvh = nullptr;
  EXPECT_THROW(buildScene(input), ProgrammingError);
  input.surfaces[0] = makeSurface("box", makeFloor(1, 0), {});
  input.surfaces[0].normals = nullptr;
  EXPECT_THROW(buildScene(input), ProgrammingError);
}

TEST(ObjectName, IsForPeople) {
  const RenderScene scene = buildScene(makeStudio());
  EXPECT_EQ(objectName(scene, {ObjectKind::mesh, 0}), "box");
  EXPECT_EQ(objectName(scene, {ObjectKind::optic, 0}), "mirror");
  EXPECT_EQ(objectName(scene, {ObjectKind::ground, 0}), "ground");
  EXPECT_EQ(objectName(scene, {ObjectKind::light, 1}), "light 2");
  EXPECT_EQ(objectName(scene, {}), "background");
}

TEST(FindHit, TakesTheNearestObject) {
  const RenderScene scene = buildScene(makeStudio());
  const auto kindAlong = [&](const Point& from, const Point& to) {
    const auto hit = findHit(scene, {from, glm::normalize(to - from)});
    return hit ? hit->object.kind : ObjectKind::none;
  };
  EXPECT_EQ(kindAlong({0, -9, 1}, {0, 0, 1}), ObjectKind::mesh);
  EXPECT_EQ(kindAlong({0, -9, 3}, {0, 0, 3}), ObjectKind::optic);
  EXPECT_EQ(kindAlong({0, -9, 3}, {4, -3, 0}), ObjectKind::ground);
  EXPECT_EQ(kindAlong({0, -9, 3}, {4, -3, 3}), ObjectKind::none);
  EXPECT_EQ(kindAlong({0, -9, -3}, {4, -9, 0}), ObjectKind::none) << "the ground is open from below";
}

TEST(FindHit, NormalsFaceTheRay) {
  SceneInput input;
  input.surfaces.push_back(makeSurface("floor", makeFloor(1, 0), {}));
  const RenderScene scene = buildScene(input);
  for (const double side : {-1.0, 1.0}) {
    const auto hit = findHit(scene, {{0.1, 0.2, 3 * side}, {0, 0, -side}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->faceNormal, Direction(0, 0, side));
    EXPECT_EQ(hit->normal, Direction(0, 0, side));
    EXPECT_DOUBLE_EQ(hit->t, 3);
  }
}

TEST(FindHit, SmoothNormalsAreInterpolated) {
  SceneInput input;
  MeshSurface surface = makeSurface("floor", makeFloor(1, 0), {});
  // Normals lean to -x on the left and to +x on the right.
  const float s = 0.6f, c = 0.8f;
  surface.normals = std::make_shared<const std::vector<glm::vec3>>(
      std::vector<glm::vec3>{{-s, 0, c}, {s, 0, c}, {s, 0, c}, {-s, 0, c}});
  surface.normalGroups = std::make_shared<const NormalGroups>(NormalGroups{surface.mesh->triangles, 4});
  input.surfaces.push_back(surface);
  const RenderScene scene = buildScene(input);
  for (const double x : {-0.75, -0.1, 0.0, 0.5}) {
    const auto hit = findHit(scene, {{x, 0.3, 2}, {0, 0, -1}});
    ASSERT_TRUE(hit);
    EXPECT_LT(glm::length(hit->normal - glm::normalize(Vector(0.6 * x, 0, 0.8))), 1e-6) << x;
    EXPECT_EQ(hit->faceNormal, Direction(0, 0, 1));
  }
}

TEST(IsBlocked, AgreesWithFindHit) {
  const RenderScene scene = buildScene(makeStudio());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-6, 6);
  for (int i = 0; i < 3000; ++i) {
    const Point from(coordinate(random), coordinate(random), 3 + 0.5 * coordinate(random));
    const Point to(coordinate(random), coordinate(random), 3 + 0.5 * coordinate(random));
    const double distance = glm::length(to - from);
    const Ray ray{from, (to - from) / distance};
    EXPECT_EQ(isBlocked(scene, ray, distance), findHit(scene, ray, distance).has_value())
        << "seed 7, ray " << i;
  }
}

}  // namespace
}  // namespace anamorph::test
