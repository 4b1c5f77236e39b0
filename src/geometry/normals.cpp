#include "geometry/normals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/check.h"
#include "base/parallel_for.h"

namespace anamorph {
namespace {

constexpr std::uint32_t unassigned = std::numeric_limits<std::uint32_t>::max();

/// `v` with length 1, whatever its length; `otherwise` when it has none.
Vector unit(const Vector& v, const Vector& otherwise) {
  // Squares of areas leave the range of double sooner than areas do.
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0 && std::isfinite(largest))) return otherwise;
  return glm::normalize(v / largest);
}

/// Side `side` of a triangle runs from corner `side` to the next one.
struct Side {
  std::uint32_t high = 0;  // the edge's larger vertex; sides are grouped by the smaller one
  std::uint32_t triangle = 0;
  std::uint8_t side = 0;
  bool ascending = false;  // from the smaller to the larger vertex
};

Side makeSide(const Triangle& t, std::uint32_t triangle, int side) {
  const std::uint32_t from = t[side], to = t[(side + 1) % 3];
  return {std::max(from, to), triangle, static_cast<std::uint8_t>(side), from < to};
}

/// Sides by smaller vertex: those of vertex v are sides[start[v]] to sides[start[v + 1]], ordered by larger
/// vertex.
struct SideTable {
  std::vector<std::size_t> start;
  std::vector<Side> sides;
};

SideTable makeSideTable(const Mesh& mesh) {
  SideTable table;
  table.start.assign(mesh.positions.size() + 2, 0);
  const auto low = [](const Triangle& t, int side) { return std::min(t[side], t[(side + 1) % 3]); };
  for (const Triangle& t : mesh.triangles) {
    for (int side = 0; side < 3; ++side) ++table.start[low(t, side) + 2];
  }
  std::partial_sum(table.start.begin(), table.start.end(), table.start.begin());
  table.sides.resize(mesh.triangles.size() * 3);
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    for (int side = 0; side < 3; ++side) table.sides[table.start[low(t, side) + 1]++] = makeSide(t, i, side);
  }
  table.start.pop_back();
  for (std::size_t v = 0; v + 1 < table.start.size(); ++v) {
    const auto first = table.sides.begin();
    std::stable_sort(first + table.start[v], first + table.start[v + 1],
                     [](const Side& a, const Side& b) { return a.high < b.high; });
  }
  return table;
}

/// Sets of corners (corner i of triangle t is 3 t + i), merged two at a time.
class CornerSets {
 public:
  explicit CornerSets(std::size_t corners) : parent_(corners) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::uint32_t find(std::uint32_t corner) {
    while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }
  void join(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::uint32_t> parent_;
};

void joinAcross(const Side& a, const Side& b, CornerSets& sets) {
  const auto corner = [](const Side& s, int end) { return 3 * s.triangle + (s.side + end) % 3; };
  // The two sides run against each other, so the start of one is the end of the other.
  sets.join(corner(a, 0), corner(b, 1));
  sets.join(corner(a, 1), corner(b, 0));
}

std::vector<Vector> sumAreas(const PointArray& points, const std::vector<Triangle>& triangles,
                             const NormalGroups& groups) {
  CHECK(triangles.size() == groups.corners.size());
  std::vector<Vector> sums(groups.count, Vector(0));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Vector area = areaVector(points, triangles[i]);
    for (const std::uint32_t group : groups.corners[i]) sums[group] += area;
  }
  return sums;
}

}  // namespace

NormalGroups makeNormalGroups(const Mesh& mesh, double creaseDegrees) {
  std::vector<Vector> unitNormal(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    unitNormal[i] = unit(areaVector(mesh.positions, mesh.triangles[i]), Vector(0));
  }
  // The small slack keeps edges of exactly the crease angle smooth despite rounding.
  const double leastCosine = std::cos(radians(std::min(creaseDegrees, 180.0))) - 1e-12;
  const auto smooth = [&](const Side& a, const Side& b) {
    const Vector &m = unitNormal[a.triangle], &n = unitNormal[b.triangle];
    return m != Vector(0) && n != Vector(0) && a.ascending != b.ascending && glm::dot(m, n) >= leastCosine;
  };

  const SideTable table = makeSideTable(mesh);
  CornerSets sets(mesh.triangles.size() * 3);
  for (std::size_t v = 0; v + 1 < table.start.size(); ++v) {
    for (std::size_t i = table.start[v], end = table.start[v + 1], next = i; i < end; i = next) {
      while (next < end && table.sides[next].high == table.sides[i].high) ++next;
      const bool isManifold = next - i == 2;
      if (isManifold && smooth(table.sides[i], table.sides[i + 1])) {
        joinAcross(table.sides[i], table.sides[i + 1], sets);
      }
    }
  }

  NormalGroups groups;
  groups.corners.resize(mesh.triangles.size());
  std::vector<std::uint32_t> groupOf(mesh.triangles.size() * 3, unassigned);
  for (std::uint32_t corner = 0; corner < groupOf.size(); ++corner) {
    std::uint32_t& group = groupOf[sets.find(corner)];
    if (group == unassigned) group = static_cast<std::uint32_t>(groups.count++);
    groups.corners[corner / 3][corner % 3] = group;
  }
  return groups;
}

std::vector<glm::vec3> computeNormals(const PointArray& points, const std::vector<Triangle>& triangles,
                                      const NormalGroups& groups, int threads) {
  const std::vector<Vector> sums = sumAreas(points, triangles, groups);
  std::vector<glm::vec3> normals(groups.count);
  parallelFor(groups.count, 16384, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) normals[i] = unit(sums[i], Vector(0, 0, 1));
  });
  return normals;
}

SmoothMesh withSmoothNormals(Mesh mesh, double creaseDegrees) {
  NormalGroups groups = makeNormalGroups(mesh, creaseDegrees);
  SmoothMesh smooth;
  for (const Vector& sum : sumAreas(mesh.positions, mesh.triangles, groups))
    smooth.normals.push_back(unit(sum, Vector(0, 0, 1)));
  smooth.mesh = std::move(mesh);
  smooth.corners = std::move(groups.corners);
  return smooth;
}

}  // namespace anamorph
