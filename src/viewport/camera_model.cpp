#include "viewport/camera_model.h"

#include <cmath>
#include <utility>

#include "raytrace/scene.h"

namespace anamorph {
namespace {

/// Corners of the model in units of its size: x right, y up, z forward; the eye is at 0.
class ModelBuilder {
 public:
  void addBox(const Point& low, const Point& high) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (int i = 0; i < 8; ++i) {
      mesh_.positions.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    }
    constexpr Triangle faces[] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                  {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    for (const Triangle& t : faces) mesh_.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }

  /// Around the z axis; closed at both ends.
  void addCone(double z0, double radius0, double z1, double radius1) {
    constexpr std::uint32_t segments = 32;
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    mesh_.positions.push_back({0, 0, z0});
    mesh_.positions.push_back({0, 0, z1});
    for (std::uint32_t i = 0; i < segments; ++i) {
      const double angle = 2 * pi * i / segments, x = std::cos(angle), y = std::sin(angle);
      mesh_.positions.push_back({radius0 * x, radius0 * y, z0});
      mesh_.positions.push_back({radius1 * x, radius1 * y, z1});
      const std::uint32_t a = first + 2 + 2 * i, b = first + 2 + 2 * ((i + 1) % segments);
      mesh_.triangles.insert(mesh_.triangles.end(),
                             {{a, b, b + 1}, {a, b + 1, a + 1}, {first, b, a}, {first + 1, a + 1, b + 1}});
    }
  }

  Mesh take() { return std::move(mesh_); }

 private:
  Mesh mesh_;
};

}  // namespace

PreparedMesh makeCameraModel(const Point& eye, const Frame& frame, double size) {
  if (!isFinite(eye) || !isFinite(frame.forward) || !isFinite(frame.up)) return {};
  ModelBuilder builder;
  builder.addBox({-0.62, -0.46, -1.95}, {0.62, 0.46, -0.62});
  builder.addBox({-0.26, 0.46, -1.6}, {0.26, 0.68, -0.9});  // finder
  builder.addCone(-0.62, 0.34, -0.42, 0.34);
  builder.addCone(-0.42, 0.3, 0, 0.54);
  Mesh mesh = builder.take();
  mesh.positions = mapPoints(mesh.positions, [&](const Point& p) {
    return eye + size * (p.x * frame.right + p.y * frame.up + p.z * frame.forward);
  });
  const MeshSurface surface = makeSurface("RT camera", std::move(mesh), Material{});
  return {surface.mesh, surface.bvh, surface.normalGroups, surface.normals, surface.box};
}

const PreparedMesh& CameraModel::at(const Camera& camera, double size) {
  return memo_.get({camera.eye, Projection(camera, 1, 1).frame(), size}, [&](const Key& key) {
    ++count_;
    return makeCameraModel(key.eye, key.frame, key.size);
  });
}

}  // namespace anamorph
