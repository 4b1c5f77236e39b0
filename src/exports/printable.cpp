#include "exports/printable.h"

#include <limits>

#include <fmt/format.h>

#include "base/error.h"

namespace anamorph {

Mesh makePrintable(const Mesh& mesh, double millimetresPerUnit) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> indexOf(mesh.positions.size(), unused);
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) indexOf[corner] = 0;
  }
  Mesh printable;
  for (std::size_t i = 0; i < indexOf.size(); ++i) {
    if (indexOf[i] == unused) continue;
    indexOf[i] = static_cast<std::uint32_t>(printable.positions.size());
    const Point p = millimetresPerUnit * mesh.positions[i];
    if (!isFinite(p))
      throw Error(fmt::format("cannot export: {} mm per unit are too many", millimetresPerUnit));
    printable.positions.push_back(p);
  }
  printable.triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    printable.triangles.push_back({indexOf[t[0]], indexOf[t[1]], indexOf[t[2]]});
  }
  return printable;
}

void appendMesh(Mesh& mesh, const Mesh& more) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::size_t i = 0; i < more.positions.size(); ++i) mesh.positions.push_back(more.positions[i]);
  for (const Triangle& t : more.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

}  // namespace anamorph
