#include "level/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <variant>
#include <vector>

#include "base/error.h"
#include "level/field_reader.h"
#include "level/json_places.h"
#include "level/level_fields.h"
#include "optics/cylinder.h"
#include "optics/plane.h"
#include "optics/sphere.h"

namespace anamorph {
namespace {

struct SceneQuad {
  PlaneMirror mirror;
};
// The position of a cylinder says nothing that its two end points do not.
struct SceneCylinder {
  CylinderMirror mirror;
  Point position{0};
};
struct SceneSphere {
  SphereMirror mirror;
};
struct SceneMesh {
  Point position{0};
};
using SceneObject = std::variant<SceneQuad, SceneCylinder, SceneSphere, SceneMesh>;
constexpr std::array sceneObjects{"quad", "cylinder", "sphere", "mesh"};

struct Scene {
  Point eye{0};
  std::vector<SceneObject> objects;
};

void fields(FieldReader& at, SceneQuad& quad) {
  const std::array keys{"v0", "v1", "v2", "v3"};
  for (std::size_t i = 0; i < keys.size(); ++i) {
    at.need({keys[i]});
    at.field(keys[i], quad.mirror.corners[i], limits::coordinates);
  }
}

void fields(FieldReader& at, SceneCylinder& cylinder) {
  at.need({"radius", "topPoint", "bottomPoint"});
  at.field("position", cylinder.position, limits::coordinates);
  at.field("radius", cylinder.mirror.radius, limits::lengths);
  at.field("topPoint", cylinder.mirror.top, limits::coordinates);
  at.field("bottomPoint", cylinder.mirror.bottom, limits::coordinates);
}

void fields(FieldReader& at, SceneSphere& sphere) {
  at.need({"position", "radius"});
  at.field("position", sphere.mirror.centre, limits::coordinates);
  at.field("radius", sphere.mirror.radius, limits::lengths);
}

void fields(FieldReader& at, SceneMesh& mesh) {
  at.need({"position"});
  at.field("position", mesh.position, limits::coordinates);
}

void fields(FieldReader& at, SceneObject& object) {
  at.choice("type", object, sceneObjects);
  std::visit([&](auto& chosen) { fields(at, chosen); }, object);
}

void fields(FieldReader& at, Scene& scene) {
  at.need({"Eye", "Objects"});
  at.field("Eye", scene.eye, limits::coordinates);
  at.list("Objects", scene.objects, 1000);
}

bool isMesh(const SceneObject& object) {
  return std::holds_alternative<SceneMesh>(object);
}

struct TakeMirror {
  Shape& shape;
  template <typename Object>
  void operator()(const Object& object) const {
    shape = object.mirror;
  }
  void operator()(const SceneMesh&) const {}
};

}  // namespace

bool isThesisScene(const JsonValue& document) {
  const auto has = [&](const char* key) { return findMember(document, key) != nullptr; };
  return (has("Eye") || has("Objects")) && !has("format");
}

Level readThesisScene(const JsonValue& document, FieldReader::Context& context) {
  Scene scene;
  FieldReader reader(document, "", context);
  fields(reader, scene);
  reader.finish();
  context.remarks.throwFaults();  // the mirror and the mesh are counted only in a sound list

  const auto meshes = std::count_if(scene.objects.begin(), scene.objects.end(), isMesh);
  const auto mirrors = static_cast<std::ptrdiff_t>(scene.objects.size()) - meshes;
  if (mirrors != 1 || meshes != 1) {
    throw Error(fmt::format("expected one mirror (quad, cylinder or sphere) and one mesh, got {} and {}",
                            mirrors, meshes),
                context.remarks.file(), whereText(findMember(document, "Objects")->place, "/Objects"));
  }

  Level level;
  for (const SceneObject& object : scene.objects) std::visit(TakeMirror{level.optic.shape()}, object);
  const Point position =
      std::get<SceneMesh>(*std::find_if(scene.objects.begin(), scene.objects.end(), isMesh)).position;
  level.original.shape = FileShape{};
  level.original.placement.position = position;
  level.camera.eye = scene.eye;
  level.camera.target = position;
  level.camera.fovDegrees = 40;
  // The files say nothing of light and 3D view: a lamp at the eye shows what the eye sees, the view starts
  // behind it.
  level.lights = {PointLight{.position = scene.eye}};
  level.ground.visible = false;  // a scene knows no floor: its sculpture may lie anywhere
  level.view = ViewSettings{.eye = position + 1.5 * (scene.eye - position), .target = position};
  return level;
}

}  // namespace anamorph
