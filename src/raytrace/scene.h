// What the tracer sees. SceneInput is a value: small things are stored, big things (meshes, trees, normals)
// are shared and immutable, so comparing two inputs is cheap and tells whether the picture can have changed.
// buildScene() adds what depends on all of it: the size, and the distance that rays are lifted off a surface.
//
// Which objects a picture shows is the caller's choice: a reflection leaves the original out, the reference
// picture leaves the optic and the sculpture out.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "geometry/bvh.h"
#include "geometry/mesh.h"
#include "geometry/normals.h"
#include "math/box.h"
#include "optics/floor.h"
#include "optics/material.h"
#include "optics/optic.h"

namespace anamorph {

/// A mesh in one material, seen from both sides.
struct MeshSurface {
  bool operator==(const MeshSurface&) const = default;

  std::string name;  ///< "sculpture", "original", ...
  std::shared_ptr<const Mesh> mesh;
  Box box;                         ///< of its positions
  std::shared_ptr<const Bvh> bvh;  ///< of this mesh
  /// Shading normals, both or neither; without them the triangles are shaded flat.
  std::shared_ptr<const NormalGroups> normalGroups;
  std::shared_ptr<const std::vector<glm::vec3>> normals;
  Material material;
};

/// The optic shows tint * reflectance * what it reflects. Its outermost edge is drawn brighter, so that a
/// clean mirror can be told from the air beside it.
struct OpticSurface {
  bool operator==(const OpticSurface&) const = default;

  Optic optic;
  Color tint{0.93, 0.97, 1};
  double reflectance = 0.88;
};

/// The studio's floor: the plane z = height, seen from above only. It fades into the background with the
/// distance from the scene, so that no horizon cuts the picture.
struct Ground {
  bool operator==(const Ground&) const = default;

  double height = 0;
  Material material{Color(0.74, 0.74, 0.73), 0.36, 0.54, 0, 1};
  double gridSpacing = 1;  ///< between the thin lines of its grid; 0 draws none
};

struct SceneInput {
  bool operator==(const SceneInput&) const = default;

  std::vector<MeshSurface> surfaces;
  std::optional<OpticSurface> optic;
  std::optional<Ground> ground;
  std::vector<PointLight> lights;
  Background background;
};

/// How large a scene is, taken once for the tracer and the 3D view: both fade the ground and lift rays by it.
struct SceneMeasure {
  Point centre{0};     ///< of the box of what stands there
  double radius = 1;   ///< of a sphere around that box; > 0
  double epsilon = 0;  ///< rays that leave a surface start this far above it

  bool operator==(const SceneMeasure&) const = default;
};
SceneMeasure measureScene(const Box& box);

/// The ground as far as it can be told from the background.
Floor floorOf(const Ground& ground, const SceneMeasure& measure);

/// The box of the surfaces and the optic.
Box boxOf(const SceneInput& input);

/// A scene that is ready to be traced.
struct RenderScene : SceneMeasure {
  SceneInput input;
};

/// Measures the scene. Every surface needs a mesh and its tree (CHECK).
RenderScene buildScene(SceneInput input);

/// A surface with its own tree and smooth normals, for a mesh that nobody else has prepared.
MeshSurface makeSurface(std::string name, Mesh mesh, const Material& material, double creaseDegrees = 30);

enum class ObjectKind : std::uint8_t { none, mesh, optic, ground, light };

/// Says which object of the scene is meant.
struct ObjectId {
  bool operator==(const ObjectId&) const = default;

  ObjectKind kind = ObjectKind::none;
  int index = 0;  ///< into the scene's surfaces or lights
};

/// For people: a surface's name, "mirror", "ground", "light 2"; "background" for none.
std::string objectName(const RenderScene& scene, const ObjectId& object);

}  // namespace anamorph
