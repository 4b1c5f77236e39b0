#include "viewport/mirror_model.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <glm/vec3.hpp>

#include "viewport/scene_block.h"

namespace anamorph {
namespace {

constexpr int segments = 192;

std::size_t countNormals(const std::vector<Triangle>& corners) {
  std::uint32_t most = 0;
  for (const Triangle& t : corners) most = std::max({most, t[0], t[1], t[2]});
  return std::size_t{most} + 1;
}

std::shared_ptr<const std::vector<float>> bordersOf(const SmoothMesh& surface, const Shape& shape) {
  constexpr float unknown = -1;
  auto borders = std::make_shared<std::vector<float>>(surface.normals.size(), unknown);
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      float& border = (*borders)[surface.normalsOf(t)[i]];
      if (border != unknown) continue;
      const Point corner = surface.mesh.positions[surface.mesh.triangles[t][i]];
      border = std::max(0.0f, static_cast<float>(shape->borderDistance(corner)));
    }
  }
  return borders;
}

}  // namespace

const MirrorTriangles& MirrorModel::at(const ViewportInput& input) {
  static const MirrorTriangles none;
  if (shaderKindsOf(input).mirror != tessellatedShader) return none;
  return memo_.get(input.level.optic.shape(), [this](const Shape& shape) { return last_ = make(shape); });
}

// While the triangles stay the same, so do the tree and what the graphics card knows of them.
MirrorTriangles MirrorModel::make(const Shape& shape) {
  SmoothMesh surface = tessellate(shape, segments);
  MirrorTriangles made;
  PreparedMesh& m = made.prepared;
  if (surface.mesh.triangles.empty() || surface.normals.empty()) return made;
  made.borders = bordersOf(surface, shape);
  auto normals = std::make_shared<std::vector<glm::vec3>>();
  for (std::size_t n = 0; n < surface.normals.size(); ++n) normals->emplace_back(surface.normals[n]);
  std::vector<Triangle> corners =
      surface.corners.empty() ? surface.mesh.triangles : std::move(surface.corners);
  const PreparedMesh& old = last_.prepared;
  const bool moves = old.mesh && old.mesh->triangles == surface.mesh.triangles &&
                     old.normalGroups->corners == corners &&
                     old.mesh->positions.size() == surface.mesh.positions.size();
  // A file's own tree was made when it was read.
  const SurfaceFile* file = shape.clip().empty() ? surfaceFileOf(shape) : nullptr;
  std::shared_ptr<Bvh> tree;
  if (moves || (file && file->tree)) {
    tree = std::make_shared<Bvh>(moves ? *old.bvh : *file->tree);
    tree->refit(surface.mesh.positions, 0);
  } else {
    tree = std::make_shared<Bvh>(surface.mesh.positions, surface.mesh.triangles, 0);
    ++count_;
  }
  if (moves) {
    m.normalGroups = old.normalGroups;
  } else {
    const std::size_t count = countNormals(corners);
    m.normalGroups = std::make_shared<const NormalGroups>(NormalGroups{std::move(corners), count});
  }
  m.bvh = std::move(tree);
  m.box = boundingBox(surface.mesh.positions);
  m.normals = std::move(normals);
  m.mesh = std::make_shared<const Mesh>(std::move(surface.mesh));
  return made;
}

}  // namespace anamorph
