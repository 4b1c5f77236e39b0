// A mesh whose points move while its triangles stay: what a drag and a morph show. Made anew every frame in buffers
// that are used again (buffer_ring.h), so neither takes memory nor builds a tree.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "pipeline/stages.h"

namespace anamorph {

/// Of an original only sculpture.mesh counts.
struct MovingMesh {
  Sculpture sculpture;
  Bvh bvh;
  std::vector<glm::vec3> normals;
};

/// For Bvh::refit, to leave out triangles with an unmapped corner. Valid as long as `status` is.
std::span<const std::uint8_t> absentPoints(const std::vector<PathStatus>& status);

/// The mesh as it is now: the tree refitted, box and parts assembled, all sharing `moving`. Normals are those that
/// `moving` has.
PreparedMesh finishMove(const std::shared_ptr<MovingMesh>& moving, std::shared_ptr<const NormalGroups> groups,
                        int threads);

/// The same for a sculpture, with its normals computed anew.
PreparedSculpture finishSculptureMove(const std::shared_ptr<MovingMesh>& moving,
                                      std::shared_ptr<const NormalGroups> groups, int threads);

}  // namespace anamorph
