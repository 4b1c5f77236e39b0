#include "pipeline/moving_mesh.h"

#include <algorithm>
#include <utility>

namespace anamorph {

// PathStatus is a byte, and 0 is mapped: what is not 0 is absent.
std::span<const std::uint8_t> absentPoints(const std::vector<PathStatus>& status) {
  const auto mapped = [](PathStatus s) { return s == PathStatus::mapped; };
  if (std::all_of(status.begin(), status.end(), mapped)) return {};
  return {reinterpret_cast<const std::uint8_t*>(status.data()), status.size()};
}

PreparedMesh finishMove(const std::shared_ptr<MovingMesh>& moving, std::shared_ptr<const NormalGroups> groups,
                        int threads) {
  const Mesh& mesh = moving->sculpture.mesh;
  moving->bvh.refit(mesh.positions, threads, absentPoints(moving->sculpture.status));
  return {{moving, &mesh},
          {moving, &moving->bvh},
          std::move(groups),
          {moving, &moving->normals},
          boundingBox(mesh.positions)};
}

PreparedSculpture finishSculptureMove(const std::shared_ptr<MovingMesh>& moving,
                                      std::shared_ptr<const NormalGroups> groups, int threads) {
  const Mesh& mesh = moving->sculpture.mesh;
  moving->normals = computeNormals(mesh.positions, mesh.triangles, *groups, threads);
  PreparedMesh prepared = finishMove(moving, std::move(groups), threads);
  return {{moving, &moving->sculpture}, std::move(prepared)};
}

}  // namespace anamorph
