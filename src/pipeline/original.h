// The original of a level: made or read once (the only input and output of the pipeline, before its stages),
// then placed.
#pragma once

#include <filesystem>
#include <memory>

#include "geometry/mesh_files.h"
#include "level/level.h"

namespace anamorph {

/// The level's own original, before it is placed: a built-in shape, or a mesh file beside the level. Throws
/// Error, and Cancelled as readFile does.
std::shared_ptr<const Mesh> loadOriginal(const OriginalShape& shape, const std::filesystem::path& levelPath,
                                         const MeshLimits& limits = {}, const CancelToken* token = nullptr);

/// In scene coordinates: unitized when asked, then scaled, rotated and moved.
std::shared_ptr<const Mesh> placeOriginal(const Mesh& shape, bool unitized, const Placement& placement);

/// The factor that makes a box as large as fits a room; sides without extent, of either, do not count. 1 when there
/// are no others.
double factorInto(const Box& own, const Box& room);

/// Scaled by one factor and moved, to be as large as fits `box` and centred in it.
Mesh fitInto(Mesh mesh, const Box& box);

}  // namespace anamorph
