// Levels to test the pipeline with: the installed ones, small enough for quick tests, and random changes as a
// drag makes them.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "level/level_json.h"
#include "pipeline/original.h"
#include "pipeline/stages.h"
#include "random_scene.h"

namespace anamorph::testing {

inline Level installedLevel(const std::string& name) {
  return loadLevel(std::filesystem::path(ANAMORPH_LEVELS) / (name + ".json")).level;
}

/// The three installed levels, with a coarser box and tolerance.
inline std::vector<Level> quickLevels() {
  std::vector<Level> levels;
  for (const char* name : {"1-plane", "2-cylinder", "3-sphere"}) {
    levels.push_back(installedLevel(name));
    std::get<BoxShape>(levels.back().original.shape).segments = 6;
    levels.back().sculpture.tolerancePixels = 1;
  }
  return levels;
}

inline std::shared_ptr<const Mesh> placedOriginal(const Level& level) {
  return placeOriginal(*loadOriginal(level.original.shape, "level.json").mesh, level.original.unitize,
                       level.original.placement);
}

/// Eye, mirror, placement and depth scale a little or much elsewhere. findProblem may find one.
inline Level changed(Level level, Random& random, double extent) {
  const Vector shift = random.point(0.3 * extent);
  const double grown = random.uniform(0.7, 1.3);
  const Point middle = middleOf(level.optic.shape());
  ShapeMap map;
  map.point = [&](const Point& p) { return middle + grown * (p - middle) + shift; };
  map.factors = Vector(grown);
  level.optic.shape() = mapShape(level.optic.shape(), map);
  level.camera.eye += random.point(extent);
  level.original.placement.position += random.point(0.5 * extent);
  level.original.placement.rotationDegrees += random.point(90 * extent);
  level.original.placement.scale *= random.uniform(0.5, 1.5);
  level.sculpture.depthScale *= random.uniform(0.5, 1.5);
  return level;
}

}  // namespace anamorph::testing
