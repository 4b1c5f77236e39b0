#include "exports/surface_topology.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace anamorph {
namespace {

// Disjoint sets (Tarjan 1975) with path halving.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);  // the smallest number stands for all, whatever the order
  }

 private:
  std::vector<std::uint32_t> parent_;
};

// A triangle's side from its corner `slot % 3` to the next one; slot / 3 is the triangle.
struct Side {
  std::uint64_t edge;  // the smaller corner above the larger one
  std::uint32_t slot;
  bool downwards;  // from the larger corner to the smaller

  bool operator<(const Side& other) const {
    return std::pair{edge, slot} < std::pair{other.edge, other.slot};
  }
};

std::vector<Side> sortedSides(const Mesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t slot = 0; slot < 3 * mesh.triangles.size(); ++slot) {
    const Triangle& t = mesh.triangles[slot / 3];
    const std::uint32_t from = t[slot % 3], to = t[(slot + 1) % 3];
    sides.push_back({std::uint64_t{std::min(from, to)} << 32 | std::max(from, to), slot, from > to});
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

std::uint32_t nextSlot(std::uint32_t slot) {
  return slot % 3 == 2 ? slot - 2 : slot + 1;
}

// The triangles' corners on both sides of an edge belong to the same fans.
void joinFans(const Mesh& mesh, std::uint32_t slot, std::uint32_t other, Sets& fans) {
  const auto cornerAt = [&](std::uint32_t s) { return mesh.triangles[s / 3][s % 3]; };
  if (cornerAt(slot) == cornerAt(other)) {
    fans.join(slot, other);
    fans.join(nextSlot(slot), nextSlot(other));
  } else {
    fans.join(slot, nextSlot(other));
    fans.join(nextSlot(slot), other);
  }
}

std::size_t countPinched(const Mesh& mesh, Sets& fans) {
  std::vector<std::uint32_t> fanCount(mesh.positions.size(), 0);
  for (std::uint32_t slot = 0; slot < 3 * mesh.triangles.size(); ++slot) {
    if (fans.root(slot) == slot) ++fanCount[mesh.triangles[slot / 3][slot % 3]];
  }
  return static_cast<std::size_t>(
      std::count_if(fanCount.begin(), fanCount.end(), [](std::uint32_t count) { return count > 1; }));
}

std::vector<Shell> collectShells(const Mesh& mesh, Sets& parts,
                                 const std::vector<std::uint32_t>& openTriangles) {
  const std::size_t count = mesh.triangles.size();
  std::vector<std::uint32_t> shellAt(count);  // of each root
  std::vector<Shell> shells;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t root = parts.root(i);
    if (root == i) {
      shellAt[i] = static_cast<std::uint32_t>(shells.size());
      shells.push_back({{}, true, 0});
    }
    Shell& shell = shells[shellAt[root]];
    shell.triangles.push_back(i);
    const Point origin = mesh.positions[mesh.triangles[root][0]];
    const Point corner = mesh.positions[mesh.triangles[i][0]];
    shell.volume += glm::dot(corner - origin, areaVector(mesh.positions, mesh.triangles[i])) / 6;
  }
  for (const std::uint32_t triangle : openTriangles) shells[shellAt[parts.root(triangle)]].isClosed = false;
  return shells;
}

}  // namespace

Surface measureSurface(const Mesh& mesh) {
  SurfaceTopology topology;
  const std::vector<Side> sides = sortedSides(mesh);
  Sets parts(mesh.triangles.size()), fans(3 * mesh.triangles.size());
  std::vector<std::uint32_t> openTriangles;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].edge == sides[begin].edge) ++end;
    for (std::size_t i = begin + 1; i < end; ++i) {
      parts.join(sides[begin].slot / 3, sides[i].slot / 3);
      joinFans(mesh, sides[begin].slot, sides[i].slot, fans);
    }
    if (end - begin == 1) {
      ++topology.borderEdges;
    } else if (end - begin > 2) {
      ++topology.crowdedEdges;
    } else if (sides[begin].downwards == sides[begin + 1].downwards) {
      ++topology.turnedEdges;
    } else {
      continue;
    }
    openTriangles.push_back(sides[begin].slot / 3);
  }
  topology.pinchedCorners = countPinched(mesh, fans);
  return {topology, collectShells(mesh, parts, openTriangles)};
}

}  // namespace anamorph
