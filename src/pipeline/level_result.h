// All that is made from a level: its original, its sculpture, its match, its pictures. The one result of commands,
// worker and window; pointers are null for what there is not yet.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/stages.h"
#include "raytrace/image.h"
#include "raytrace/tracer.h"

namespace anamorph {

/// The three pictures of the preview, all of one size.
struct Previews {
  std::shared_ptr<const Image> reflection;
  std::shared_ptr<const Image> original;
  std::shared_ptr<const Image> difference;

  bool operator==(const Previews&) const = default;
};

struct LevelResult {
  Level level;
  std::shared_ptr<const Mesh> shape;  ///< the original before it is placed
  PreparedMesh original;
  std::shared_ptr<const Mesh> source;  ///< PlacedOriginal::source of original.h
  PreparedSculpture sculpture;         ///< without triangles when there is a problem, unless it is frozen
  std::optional<std::string> problem;  ///< why there is no sculpture or nothing to compare, and what to do
  std::vector<std::string> warnings;
  std::vector<std::string> shapeWarnings;  ///< about the file that the shape was read from
  std::shared_ptr<const Match> match;
  Previews previews;
  bool refined = false;   ///< the sculpture is as fine as the level asks for
  bool complete = false;  ///< and match and pictures are of it

  // What the window draws of the RT camera's pixel grid, on request.
  std::shared_ptr<const RenderScene> scene;           ///< what the RT camera sees
  std::shared_ptr<const Image> screen;                ///< one pixel for every cell of the pixel grid
  std::shared_ptr<const std::vector<RayTree>> trees;  ///< of every cell, row by row
};

/// Whether there is a sculpture to be seen: a frozen one is, whatever the problem.
inline bool hasSculpture(const LevelResult& result) {
  return result.sculpture.sculpture && !result.sculpture.sculpture->mesh.triangles.empty();
}

/// Of what the sculpture is made from; measured only where that is not the original as it stands.
inline Box sourceBox(const LevelResult& result) {
  return result.source == result.original.mesh ? result.original.box : boundingBox(result.source->positions);
}

}  // namespace anamorph
