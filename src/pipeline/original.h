// The original of a level: made or read once (the only input and output of the pipeline, before its stages),
// then placed.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geometry/mesh_files.h"
#include "level/level.h"

namespace anamorph {

struct LoadedOriginal {
  std::shared_ptr<const Mesh> mesh;
  std::vector<std::string> warnings;  ///< about its file, as loadMesh has them
  UpGuess up = {};                    ///< likewise; the mesh is turned as its shape says
};

/// The level's own original, before it is placed, with z up: a built-in shape, a mesh file beside the level, or a mesh
/// inside it.
/// Throws Error, and Cancelled as readFile does.
LoadedOriginal loadOriginal(const OriginalShape& shape, const std::filesystem::path& levelPath,
                            const MeshLimits& limits = {}, const CancelToken* token = nullptr);

/// In scene coordinates: unitized when asked, then scaled, rotated and moved.
std::shared_ptr<const Mesh> placeOriginal(const Mesh& shape, bool unitized, const Placement& placement);

/// A level's original where it stands, and where it stood when the sculpture was made from it: the same mesh unless a
/// frozen sculpture's original has moved.
struct PlacedOriginal {
  PlacedOriginal(std::shared_ptr<const Mesh> both) : mesh(both), source(std::move(both)) {}
  PlacedOriginal(std::shared_ptr<const Mesh> now, std::shared_ptr<const Mesh> then)
      : mesh(std::move(now)), source(std::move(then)) {}

  std::shared_ptr<const Mesh> mesh, source;
};
PlacedOriginal placeOriginal(const Mesh& shape, const LevelScene& level);

/// The factor that makes a box as large as fits a room; sides without extent, of either, do not count. 1 when there
/// are no others.
double factorInto(const Box& own, const Box& room);

/// Scaled by one factor and moved, to be as large as fits `box` and centred in it.
Mesh fitInto(Mesh mesh, const Box& box);

}  // namespace anamorph
