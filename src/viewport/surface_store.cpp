#include "viewport/surface_store.h"

#include <algorithm>
#include <cmath>

#include "base/language.h"
#include "gl/load_gl.h"

namespace anamorph {
namespace {

constexpr const char* tooLarge[] = {
    "the sculpture has too many triangles for this graphics card and is not shown in the 3D view",
    "the original has too many triangles for this graphics card and is not shown in the 3D view",
    "the RT camera's model has too many triangles for this graphics card and is not shown in the 3D view"};

/// Nothing is drawn of a mesh that is not whole.
SurfaceSource completeOrNone(const SurfaceSource& source) {
  const PreparedMesh& m = source.prepared;
  const bool complete =
      m.mesh && m.bvh && m.normalGroups && m.normals && !m.bvh->empty() && !m.normals->empty();
  return complete ? source : SurfaceSource{};
}

/// Texels of nodes, positions, triangles and normals.
std::array<std::size_t, 4> lengthsOf(const SurfaceSource& source) {
  const PreparedMesh& m = source.prepared;
  if (!m.mesh) return {};
  return {2 * m.bvh->nodes().size(), m.mesh->positions.size(), 2 * m.bvh->triangleOrder().size(),
          m.normals->size()};
}

float finite(float x) {
  constexpr float most = 1e30f;
  return x > -most ? std::min(x, most) : -most;  // not a number too
}

glm::vec4 finite(const glm::vec4& v) {
  return {finite(v.x), finite(v.y), finite(v.z), finite(v.w)};
}

bool sameTriangles(const PreparedMesh& a, const PreparedMesh& b) {
  return a.normalGroups == b.normalGroups && a.bvh && b.bvh &&
         (a.bvh == b.bvh || a.bvh->triangleOrder() == b.bvh->triangleOrder());
}

}  // namespace

bool fasterTraced(std::int64_t triangles, const Framebuffer& target) {
  return triangles > std::int64_t{target.width()} * target.height() && isSoftwareRenderer();
}

SurfaceStore::SurfaceStore()
    : arrays_{TexelArrays(TexelFormat::rgba32f, gpuSurfaceCount),
              TexelArrays(TexelFormat::rgba32f, gpuSurfaceCount),
              TexelArrays(TexelFormat::rgba32ui, gpuSurfaceCount),
              TexelArrays(TexelFormat::rgba32f, gpuSurfaceCount)} {}

void SurfaceStore::update(const SurfaceSources& wanted) {
  SurfaceSources sources;
  std::transform(wanted.begin(), wanted.end(), sources.begin(), completeOrNone);
  Lengths lengths{};
  leaveOutWhatDoesNotFit(sources, lengths);
  std::array<bool, arrayCount> moved;
  for (int a = 0; a < arrayCount; ++a) moved[a] = arrays_[a].reserve(lengths[a]);
  for (int i = 0; i < gpuSurfaceCount; ++i) {
    const SurfaceSource &now = sources[i], &before = sources_[i];
    const PreparedMesh &m = now.prepared, &old = before.prepared;
    slot(i, now);
    if (!m.mesh) continue;
    const bool otherPoints = m.mesh != old.mesh || now.sculpture != before.sculpture || m.bvh != old.bvh;
    if (moved[SurfaceUnits::nodes] || m.bvh != old.bvh) writeNodes(i, now);
    if (moved[SurfaceUnits::positions] || otherPoints) writePositions(i, now);
    if (moved[SurfaceUnits::triangles] || !sameTriangles(m, old)) writeTriangles(i, now);
    if (moved[SurfaceUnits::normals] || m.normals != old.normals) writeNormals(i, now);
  }
  sources_ = sources;
}

std::string SurfaceStore::problem() const {
  std::string problem;
  for (const int i : leftOut_) problem += (problem.empty() ? "" : "; ") + std::string(tr(tooLarge[i]));
  return problem;
}

void SurfaceStore::leaveOutWhatDoesNotFit(SurfaceSources& sources, Lengths& lengths) {
  leftOut_.clear();
  for (;;) {
    int largest = 0;
    for (int i = 0; i < gpuSurfaceCount; ++i) {
      const auto own = lengthsOf(sources[i]);
      for (int a = 0; a < arrayCount; ++a) lengths[a][i] = own[a];
      if (own[SurfaceUnits::triangles] > lengths[SurfaceUnits::triangles][largest]) largest = i;
    }
    if (std::all_of(lengths.begin(), lengths.end(), [](const auto& l) { return TexelArrays::fits(l); }))
      return;
    leftOut_.push_back(largest);
    sources[largest] = {};
  }
}

void SurfaceStore::slot(int i, const SurfaceSource& source) {
  SurfaceSlot& slot = slots_[i];
  const PreparedMesh& m = source.prepared;
  if (!m.mesh) {
    slot = {};
    return;
  }
  for (int a = 0; a < arrayCount; ++a) slot.first[a] = arrays_[a].first(i);
  // Nodes and triangles are two texels each; the order is that of scene.glsl: node, triangle, vertex, normal.
  slot.first = {slot.first[0] / 2, slot.first[2] / 2, slot.first[1], slot.first[3]};
  slot.triangles = static_cast<int>(m.bvh->triangleOrder().size());
  slot.centre = m.bvh->centre();
  const BvhNode& root = m.bvh->nodes().front();
  slot.root = static_cast<int>(8 * root.link + root.count);
  slot.box = {};
  slot.radius = 0;
  for (int axis = 0; axis < 3; ++axis) {
    slot.box.min[axis] = slot.centre[axis] + finite(root.min[axis]);
    slot.box.max[axis] = slot.centre[axis] + finite(root.max[axis]);
    slot.radius = std::max({slot.radius, double{-finite(root.min[axis])}, double{finite(root.max[axis])}});
  }
  if (slot.box.empty()) slot.triangles = 0;  // no triangle is in the tree any more
}

void SurfaceStore::writePositions(int i, const SurfaceSource& source) {
  const PointArray& points = source.prepared.mesh->positions;
  const std::vector<PathStatus>* status = source.sculpture ? &source.sculpture->status : nullptr;
  if (status && status->size() != points.size()) status = nullptr;
  const Point centre = source.prepared.bvh->centre();
  floats_.resize(points.size());
  bool whole = true;
  for (std::size_t v = 0; v < points.size(); ++v) {
    const float usable =
        !status || (*status)[v] == PathStatus::mapped ? 1.0f : -static_cast<float>((*status)[v]);
    whole &= usable > 0;
    floats_[v] = finite(glm::vec4(glm::vec3(points[v] - centre), usable));
  }
  slots_[i].whole = whole;
  arrays_[SurfaceUnits::positions].write(i, floats_.data(), floats_.size());
}

void SurfaceStore::writeNormals(int i, const SurfaceSource& source) {
  const auto& normals = *source.prepared.normals;
  floats_.resize(normals.size());
  std::transform(normals.begin(), normals.end(), floats_.begin(),
                 [](const glm::vec3& n) { return finite(glm::vec4(n, 0)); });
  arrays_[SurfaceUnits::normals].write(i, floats_.data(), floats_.size());
}

void SurfaceStore::writeNodes(int i, const SurfaceSource& source) {
  const auto& nodes = source.prepared.bvh->nodes();
  floats_.resize(2 * nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const BvhNode& node = nodes[n];
    // Numbers instead of bit patterns: as a float's bits, small ones would be denormals and may become 0.
    floats_[2 * n] = finite(glm::vec4(node.min[0], node.min[1], node.min[2], node.link));
    floats_[2 * n + 1] = finite(glm::vec4(node.max[0], node.max[1], node.max[2], node.count));
  }
  arrays_[SurfaceUnits::nodes].write(i, floats_.data(), floats_.size());
}

void SurfaceStore::writeTriangles(int i, const SurfaceSource& source) {
  const PreparedMesh& m = source.prepared;
  const auto& order = m.bvh->triangleOrder();
  numbers_.resize(2 * order.size());
  for (std::size_t t = 0; t < order.size(); ++t) {
    const Triangle &corners = m.mesh->triangles[order[t]], &normals = m.normalGroups->corners[order[t]];
    numbers_[2 * t] = {corners[0], corners[1], corners[2], 0};
    numbers_[2 * t + 1] = {normals[0], normals[1], normals[2], 0};
  }
  arrays_[SurfaceUnits::triangles].write(i, numbers_.data(), numbers_.size());
}

void SurfaceStore::bind() const {
  for (int a = 0; a < arrayCount; ++a) arrays_[a].bind(a);
}

}  // namespace anamorph
