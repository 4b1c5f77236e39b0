#include "raytrace/scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/check.h"
#include "raytrace/look.h"

namespace anamorph {
namespace {

// The trees are walked in float: a hit is off by a few 2^-24 of the coordinates. This stays well above that
// and well below a pixel.
constexpr double relativeEpsilon = 1.0 / (1 << 18);

// What is nowhere has no part in the scene's size.
void extendIfFinite(Box& box, const Box& other) {
  if (isFinite(other.min) && isFinite(other.max)) box.extend(other);
}

}  // namespace

SceneMeasure measureScene(const Box& box) {
  SceneMeasure measure;
  measure.epsilon = relativeEpsilon;
  if (box.empty()) return measure;
  measure.centre = box.centre();
  const double radius = box.diagonal() / 2;
  if (std::isfinite(radius) && radius > 0) measure.radius = radius;
  const Vector farthest = glm::max(glm::abs(box.min), glm::abs(box.max));
  measure.epsilon = relativeEpsilon * std::max({measure.radius, farthest.x, farthest.y, farthest.z});
  return measure;
}

Floor floorOf(const Ground& ground, const SceneMeasure& measure) {
  return {ground.height, measure.centre, look::fadeEnd * measure.radius};
}

Box boxOf(const SceneInput& input) {
  Box box;
  for (const MeshSurface& surface : input.surfaces) extendIfFinite(box, surface.box);
  if (input.optic) extendIfFinite(box, boxOf(input.optic->optic));
  return box;
}

RenderScene buildScene(SceneInput input) {
  for (const MeshSurface& surface : input.surfaces) {
    CHECK(surface.mesh && surface.bvh && !surface.normals == !surface.normalGroups);
  }
  RenderScene scene{measureScene(boxOf(input)), {}};
  scene.input = std::move(input);
  return scene;
}

MeshSurface makeSurface(std::string name, Mesh mesh, const Material& material, double creaseDegrees) {
  MeshSurface surface;
  surface.name = std::move(name);
  surface.material = material;
  surface.box = boundingBox(mesh.positions);
  const auto groups = std::make_shared<const NormalGroups>(makeNormalGroups(mesh, creaseDegrees));
  surface.normals =
      std::make_shared<const std::vector<glm::vec3>>(computeNormals(mesh.positions, mesh.triangles, *groups));
  surface.normalGroups = groups;
  surface.bvh = std::make_shared<const Bvh>(mesh.positions, mesh.triangles);
  surface.mesh = std::make_shared<const Mesh>(std::move(mesh));
  return surface;
}

std::string objectName(const RenderScene& scene, const ObjectId& object) {
  switch (object.kind) {
    case ObjectKind::mesh:
      return scene.input.surfaces.at(object.index).name;
    case ObjectKind::optic:
      return "mirror";
    case ObjectKind::ground:
      return "ground";
    case ObjectKind::light:
      return fmt::format("light {}", object.index + 1);
    case ObjectKind::none:
      break;
  }
  return "background";
}

}  // namespace anamorph
