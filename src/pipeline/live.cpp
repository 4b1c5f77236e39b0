#include "pipeline/live.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "base/parallel_for.h"

namespace anamorph {
namespace {

bool isWhole(const Sculpture& sculpture) {
  const StatusCounts& counts = sculpture.originalStatus;
  return !sculpture.mesh.triangles.empty() &&
         std::all_of(counts.begin() + 1, counts.end(), [](std::size_t count) { return count == 0; });
}

// The original itself as a sculpture that nothing has happened to yet.
Sculpture undeformed(const Mesh& original) {
  Sculpture sculpture;
  sculpture.mesh = original;
  sculpture.original = original.positions;
  sculpture.status.assign(original.positions.size(), PathStatus::mapped);
  sculpture.source.resize(original.positions.size());
  for (std::uint32_t t = 0; t < original.triangles.size(); ++t) {
    const Triangle& corners = original.triangles[t];
    sculpture.source[corners[0]] = {t, 0, 0};
    sculpture.source[corners[1]] = {t, 1, 0};
    sculpture.source[corners[2]] = {t, 0, 1};
    sculpture.sourceTriangle.push_back(t);
  }
  return sculpture;
}

bool scalesEvenly(const Placement& placement) {
  const Vector& s = placement.scale;
  return s.x > 0 && s.x == s.y && s.y == s.z;
}

void turnNormals(const std::vector<glm::vec3>& from, const Vector& rotationDegrees,
                 std::vector<glm::vec3>& to) {
  const glm::mat3 rotation(rotationMatrix(rotationDegrees));
  to.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) to[i] = rotation * from[i];
}

// Of the original's own vertices.
StatusCounts ownStatus(const VertexMap& map, const Mesh& original, int threads) {
  MappedPoints mapped;
  mapPointsThrough(map, original.positions, mapped, threads);
  return countStatus(mapped.status);
}

}  // namespace

LiveOriginal::LiveOriginal(std::shared_ptr<const Mesh> shape, PreparedMesh placed)
    : shape_(std::move(shape)), start_(std::move(placed)) {
  CHECK(shape_->positions.size() == start_.mesh->positions.size());
  prototype_.sculpture.mesh = *start_.mesh;
  prototype_.bvh = *start_.bvh;
  prototype_.normals = *start_.normals;
  shapeNormals_ = computeNormals(shape_->positions, shape_->triangles, *start_.normalGroups);
}

PreparedMesh LiveOriginal::place(bool unitized, const Placement& placement, int threads) {
  if (unitized && !unitized_) unitized_ = std::make_shared<const Mesh>(unitize(*shape_));
  const PointArray& from = unitized ? unitized_->positions : shape_->positions;
  const std::shared_ptr<MovingMesh> moving = ring_.take([&] { return prototype_; });
  Mesh& mesh = moving->sculpture.mesh;
  PointArray& to = mesh.positions;
  const PlacementMap map(placement);
  parallelFor(from.size(), 8192, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) to.set(i, map(from[i]));
  });
  if (scalesEvenly(placement)) {
    turnNormals(shapeNormals_, placement.rotationDegrees, moving->normals);
  } else {
    moving->normals = computeNormals(to, mesh.triangles, *start_.normalGroups, threads);
  }
  return finishMove(moving, start_.normalGroups, threads);
}

LiveSculpture::LiveSculpture(const PreparedMesh& original, const PreparedSculpture& settled)
    : ownTriangles_(!settled.sculpture || !isWhole(*settled.sculpture)) {
  if (ownTriangles_) {
    normalGroups_ = original.normalGroups;
    prototype_ = {{undeformed(*original.mesh), *original.bvh, *original.normals}, nullptr};
  } else {
    normalGroups_ = settled.prepared.normalGroups;
    prototype_ = {{*settled.sculpture, *settled.prepared.bvh, *settled.prepared.normals}, nullptr};
    prototype_.moving.sculpture.folded = {};
  }
}

PreparedSculpture LiveSculpture::follow(const VertexMap& map, const std::shared_ptr<const Mesh>& original,
                                        int threads) {
  const std::shared_ptr<Buffer> buffer = ring_.take([&] { return prototype_; });
  const std::shared_ptr<MovingMesh> moving(buffer, &buffer->moving);
  Sculpture& sculpture = moving->sculpture;
  if (buffer->original != original) {
    if (ownTriangles_) {
      sculpture.original = original->positions;
    } else {
      placeSources(sculpture, *original, sculpture.original);
    }
    buffer->original = original;
  }
  remapSculpture(map, sculpture, threads);
  const bool whole = absentPoints(sculpture.status).empty();
  if (ownTriangles_) {
    sculpture.originalStatus = countStatus(sculpture.status);
  } else {
    // The original's vertices are among those of the refined sculpture: all mapped when all of these are.
    sculpture.originalStatus =
        whole ? StatusCounts{original->positions.size()} : ownStatus(map, *original, threads);
  }
  return finishSculptureMove(moving, normalGroups_, threads);
}

}  // namespace anamorph
