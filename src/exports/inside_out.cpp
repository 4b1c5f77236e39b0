#include "exports/inside_out.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "geometry/bvh.h"

namespace anamorph {
namespace {

// Askew, so that it runs along no edge.
const Direction away = glm::normalize(Vector(0.537, 0.298, 0.789));

struct Search {
  const Mesh& mesh;
  const Surface& surface;
  Bvh bvh;
  std::vector<std::size_t> shellOf;  // each triangle
};

Search makeSearch(const Mesh& mesh, const Surface& surface) {
  Search search{mesh, surface, Bvh(mesh.positions, mesh.triangles), {}};
  search.shellOf.resize(mesh.triangles.size());
  for (std::size_t i = 0; i < surface.shells.size(); ++i) {
    for (const std::uint32_t triangle : surface.shells[i].triangles) search.shellOf[triangle] = i;
  }
  return search;
}

// The shells that a ray from a triangle's middle leaves: those it goes through an odd number of times.
std::vector<std::size_t> shellsLeft(const Search& search, std::uint32_t triangle, std::size_t own) {
  const PointArray& points = search.mesh.positions;
  const Triangle& t = search.mesh.triangles[triangle];
  const Ray ray{(points[t[0]] + points[t[1]] + points[t[2]]) / 3.0, away};
  std::map<std::size_t, bool> isOdd;
  BvhHit hit;
  for (double from = 0; search.bvh.closestHit(ray, hit, from); from = hit.t) {
    bool& odd = isOdd[search.shellOf[hit.triangle]];
    odd = !odd;
  }
  std::vector<std::size_t> left;
  for (const auto& [shell, odd] : isOdd) {
    if (odd && shell != own) left.push_back(shell);
  }
  return left;
}

// The shells around one, by three of its triangles: a single one may lie in another shell's surface.
std::vector<std::size_t> shellsAround(const Search& search, std::size_t own) {
  const std::vector<std::uint32_t>& triangles = search.surface.shells[own].triangles;
  std::map<std::size_t, int> votes;
  for (const std::size_t i : std::array{std::size_t{0}, triangles.size() / 3, 2 * triangles.size() / 3}) {
    for (const std::size_t shell : shellsLeft(search, triangles[i], own)) ++votes[shell];
  }
  std::vector<std::size_t> around;
  for (const auto& [shell, count] : votes) {
    if (count >= 2) around.push_back(shell);
  }
  return around;
}

}  // namespace

std::vector<std::size_t> findInsideOut(const Mesh& mesh, const Surface& surface) {
  const std::vector<Shell>& shells = surface.shells;
  const auto facesInwards = [](const Shell& shell) { return shell.isClosed && shell.volume < 0; };
  if (std::none_of(shells.begin(), shells.end(), facesInwards)) return {};
  const Search search = makeSearch(mesh, surface);
  std::vector<std::vector<std::size_t>> around(shells.size());
  for (std::size_t i = 0; i < shells.size(); ++i) around[i] = shellsAround(search, i);
  std::vector<std::size_t> insideOut;
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (!shells[i].isClosed) continue;
    const auto outermost = std::find_if(around[i].begin(), around[i].end(),
                                        [&](std::size_t shell) { return around[shell].empty(); });
    const std::size_t decides = outermost == around[i].end() ? i : *outermost;
    if (facesInwards(shells[decides])) insideOut.push_back(i);
  }
  return insideOut;
}

}  // namespace anamorph
