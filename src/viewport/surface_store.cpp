#include "viewport/surface_store.h"

#include <algorithm>

#include <glm/vec4.hpp>

#include "base/language.h"
#include "gl/load_gl.h"
#include "viewport/bands.h"

namespace anamorph {
namespace {

constexpr const char* tooLarge[] = {
    "the sculpture has too many triangles for this graphics card and is not shown in the 3D view",
    "the original has too many triangles for this graphics card and is not shown in the 3D view",
    "the RT camera's model has too many triangles for this graphics card and is not shown in the 3D view",
    "the mirror has too many triangles for this graphics card and is not shown in the 3D view"};

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

/// Of the vertices; null: all of them are usable.
const std::vector<PathStatus>* statusOf(const SurfaceSource& source) {
  if (!source.sculpture) return nullptr;
  const auto& status = source.sculpture->status;
  return status.size() == source.prepared.mesh->positions.size() ? &status : nullptr;
}

// Texels [from, to) of what shaders/bvh.glsl reads.

std::vector<glm::vec4> positionTexels(const SurfaceSource& source, std::size_t from, std::size_t to) {
  const PointArray& points = source.prepared.mesh->positions;
  const std::vector<PathStatus>* status = statusOf(source);
  const Point centre = source.prepared.bvh->centre();
  std::vector<glm::vec4> texels;
  texels.reserve(to - from);
  for (std::size_t v = from; v < to; ++v) {
    const float usable =
        !status || (*status)[v] == PathStatus::mapped ? 1.0f : -static_cast<float>((*status)[v]);
    texels.push_back(finite(glm::vec4(glm::vec3(points[v] - centre), usable)));
  }
  return texels;
}

std::vector<glm::vec4> normalTexels(const SurfaceSource& source, std::size_t from, std::size_t to) {
  std::vector<glm::vec4> texels;
  texels.reserve(to - from);
  for (std::size_t n = from; n < to; ++n) {
    const float border = source.borders ? (*source.borders)[n] : 0;
    texels.push_back(finite(glm::vec4((*source.prepared.normals)[n], border)));
  }
  return texels;
}

std::vector<glm::vec4> nodeTexels(const PreparedMesh& mesh, std::size_t from, std::size_t to) {
  std::vector<glm::vec4> texels;
  texels.reserve(to - from);
  for (std::size_t t = from; t < to; ++t) {
    const BvhNode& node = mesh.bvh->nodes()[t / 2];
    // Numbers instead of bit patterns: as a float's bits, small ones would be denormals and may become 0.
    texels.push_back(finite(t % 2 == 0 ? glm::vec4(node.min[0], node.min[1], node.min[2], node.link)
                                       : glm::vec4(node.max[0], node.max[1], node.max[2], node.count)));
  }
  return texels;
}

std::vector<glm::uvec4> triangleTexels(const PreparedMesh& mesh, std::size_t from, std::size_t to) {
  const auto& order = mesh.bvh->triangleOrder();
  std::vector<glm::uvec4> texels;
  texels.reserve(to - from);
  for (std::size_t t = from; t < to; ++t) {
    const auto& lists = t % 2 == 0 ? mesh.mesh->triangles : mesh.normalGroups->corners;
    const Triangle& corners = lists[order[t / 2]];
    texels.push_back({corners[0], corners[1], corners[2], 0});
  }
  return texels;
}

bool sameTriangles(const PreparedMesh& a, const PreparedMesh& b) {
  return a.normalGroups == b.normalGroups && a.bvh && b.bvh &&
         (a.bvh == b.bvh || a.bvh->triangleOrder() == b.bvh->triangleOrder());
}

}  // namespace

bool fasterTraced(std::int64_t triangles, std::int64_t pixels) {
  return triangles > pixels && isSoftwareRenderer();
}

SurfaceStore::SurfaceStore()
    : arrays_{TexelArrays(TexelFormat::rgba32f, gpuSurfaceCount),
              TexelArrays(TexelFormat::rgba32f, gpuSurfaceCount),
              TexelArrays(TexelFormat::rgba32ui, gpuSurfaceCount),
              TexelArrays(TexelFormat::rgba32f, gpuSurfaceCount)} {}

void SurfaceStore::update(const SurfaceSources& wanted, Piecework& work) {
  SurfaceSources sources;
  std::transform(wanted.begin(), wanted.end(), sources.begin(), completeOrNone);
  Lengths lengths{};
  leaveOutWhatDoesNotFit(sources, lengths);
  std::array<bool, arrayCount> moved;
  for (int a = 0; a < arrayCount; ++a) {
    moved[a] = arrays_[a].reserve(lengths[a]);
    if (!arrays_[a].moved()) continue;
    work.add(1, [this, a](int, int) {
      arrays_[a].make();
      bind();
    });
  }
  for (int i = 0; i < gpuSurfaceCount; ++i) {
    const SurfaceSource &now = sources[i], &before = sources_[i];
    const PreparedMesh &m = now.prepared, &old = before.prepared;
    slot(i, now);
    std::array<bool, arrayCount> other{};
    other[SurfaceUnits::nodes] = m.bvh != old.bvh;
    other[SurfaceUnits::positions] =
        m.mesh != old.mesh || now.sculpture != before.sculpture || m.bvh != old.bvh;
    other[SurfaceUnits::triangles] = !sameTriangles(m, old);
    other[SurfaceUnits::normals] = m.normals != old.normals || now.borders != before.borders;
    for (int a = 0; a < arrayCount; ++a) {
      missing_[a][i] = m.mesh && (missing_[a][i] || moved[a] || other[a]);
      if (missing_[a][i]) addUpload(work, a, i, lengths[a][i]);
    }
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
  const auto* status = statusOf(source);
  slot.whole = !status || std::all_of(status->begin(), status->end(),
                                      [](PathStatus s) { return s == PathStatus::mapped; });
}

void SurfaceStore::addUpload(Piecework& work, int array, int i, std::size_t texels) {
  constexpr int rowsInPiece = 16;  // half a megabyte
  const ListPieces pieces{static_cast<int>(texels), rowsInPiece * TexelArrays::rowLength};
  work.add(pieces.count(), [this, array, i, pieces](int from, int to) {
    upload(array, i, pieces.begin(from), pieces.begin(to));
    if (to == pieces.count()) missing_[array][i] = false;
  });
}

void SurfaceStore::upload(int array, int i, std::size_t from, std::size_t to) {
  const SurfaceSource& source = sources_[i];
  const auto send = [&](const auto& texels) { arrays_[array].write(i, from, texels.data(), texels.size()); };
  switch (array) {
    case SurfaceUnits::nodes:
      return send(nodeTexels(source.prepared, from, to));
    case SurfaceUnits::positions:
      return send(positionTexels(source, from, to));
    case SurfaceUnits::triangles:
      return send(triangleTexels(source.prepared, from, to));
    case SurfaceUnits::normals:
      return send(normalTexels(source, from, to));
  }
}

void SurfaceStore::bind() const {
  for (int a = 0; a < arrayCount; ++a) arrays_[a].bind(a);
}

}  // namespace anamorph
