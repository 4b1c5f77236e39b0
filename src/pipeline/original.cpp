#include "pipeline/original.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.h"
#include "geometry/shapes.h"
#include "level/freeze.h"
#include "level/level_json.h"

namespace anamorph {
namespace {

struct ShapeMaker {
  const std::filesystem::path& levelPath;
  const MeshLimits& limits;
  const CancelToken* token;

  LoadedMesh operator()(const BoxShape& s) const { return {makeBox(s.size, s.segments), {}}; }
  LoadedMesh operator()(const SphereShape& s) const { return {makeSphere(s.radius, s.segments), {}}; }
  LoadedMesh operator()(const TorusKnotShape& s) const {
    return {makeTorusKnot(s.p, s.q, s.tubeRadius, s.segments, s.sides), {}};
  }
  LoadedMesh operator()(const LetterFShape& s) const { return {makeLetterF(s.height, s.segments), {}}; }
  LoadedMesh operator()(const PawnShape& s) const { return {makePawn(s.height, s.segments), {}}; }
  LoadedMesh operator()(const FileShape& s) const {
    const bool isInside = !s.obj->empty();
    try {
      if (!isInside) return loadMesh(modelPath(s, levelPath), limits, token);
      const auto name = std::filesystem::path(s.path).filename().replace_extension(".obj");
      return readMesh(*s.obj, name.string(), limits);
    } catch (const Error& error) {
      throw Error(error.what(), levelPath.string(),
                  isInside ? "/original/shape/obj" : "/original/shape/path");
    }
  }
};

}  // namespace

LoadedOriginal loadOriginal(const OriginalShape& shape, const std::filesystem::path& levelPath,
                            const MeshLimits& limits, const CancelToken* token) {
  LoadedMesh loaded = std::visit(ShapeMaker{levelPath, limits, token}, shape);
  const auto* file = std::get_if<FileShape>(&shape);
  Mesh upright = standUp(std::move(loaded.mesh), file ? file->up : ModelUp::z);
  return {std::make_shared<const Mesh>(std::move(upright)), std::move(loaded.warnings), loaded.up};
}

std::shared_ptr<const Mesh> placeOriginal(const Mesh& shape, bool unitized, const Placement& placement) {
  Mesh mesh = unitized ? unitize(shape) : shape;
  mesh.positions = mapPoints(mesh.positions, PlacementMap(placement));
  return std::make_shared<const Mesh>(std::move(mesh));
}

PlacedOriginal placeOriginal(const Mesh& shape, const LevelScene& level) {
  PlacedOriginal placed(placeOriginal(shape, level.original.unitize, level.original.placement));
  if (hasOriginalMoved(level)) {
    const SculptureInputs& kept = *level.sculpture.frozen;
    placed.source = placeOriginal(shape, kept.unitize, kept.placement);
  }
  return placed;
}

double factorInto(const Box& own, const Box& room) {
  double factor = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double side = own.size()[axis], most = room.size()[axis];
    if (side > 0 && most > 0) factor = std::min(factor, most / side);
  }
  return factor > 0 && std::isfinite(factor) ? factor : 1;
}

Mesh fitInto(Mesh mesh, const Box& box) {
  const Box own = boundingBox(mesh.positions);
  if (own.empty() || box.empty()) return mesh;
  const double factor = factorInto(own, box);
  mesh.positions =
      mapPoints(mesh.positions, [&](const Point& p) { return box.centre() + factor * (p - own.centre()); });
  return mesh;
}

}  // namespace anamorph
