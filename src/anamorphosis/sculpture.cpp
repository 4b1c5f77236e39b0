#include "anamorphosis/sculpture.h"

#include <limits>
#include <utility>

#include "anamorphosis/refine.h"

namespace anamorph {
namespace {

// Appends a triangle as the mirror turns it around.
void addTriangle(Sculpture& sculpture, Triangle t, std::uint32_t source, bool reversed) {
  if (reversed) std::swap(t[1], t[2]);
  sculpture.mesh.triangles.push_back(t);
  sculpture.sourceTriangle.push_back(source);
}

bool allMapped(const Triangle& t, const std::vector<PathStatus>& status) {
  return status[t[0]] == PathStatus::mapped && status[t[1]] == PathStatus::mapped &&
         status[t[2]] == PathStatus::mapped;
}

void noteFolds(const Folds& folds, Sculpture& sculpture) {
  sculpture.folded = {folds.count, folds.share, folds.foci};
}

bool isFolded(const Folds& folds, std::size_t triangle) {
  return !folds.folded.empty() && folds.folded[triangle];
}

Sculpture mapOwnVertices(const DeformInput& input, int threads, const CancelToken& token) {
  const Mesh& mesh = *input.original;
  MappedPoints mapped;
  mapPointsThrough(input.map, mesh.positions, mapped, threads);
  Sculpture sculpture;
  sculpture.mesh.positions = std::move(mapped.points);
  sculpture.status = std::move(mapped.status);
  sculpture.original = mesh.positions;
  sculpture.source.resize(mesh.positions.size());
  const Folds folds = findFolds(input.map, mesh.positions, mesh.triangles, sculpture.status, threads, token);
  noteFolds(folds, sculpture);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    sculpture.source[triangle[0]] = {t, 0, 0};
    sculpture.source[triangle[1]] = {t, 1, 0};
    sculpture.source[triangle[2]] = {t, 0, 1};
    if (allMapped(triangle, sculpture.status) && !isFolded(folds, t)) {
      addTriangle(sculpture, triangle, t, folds.reversed);
    }
  }
  sculpture.originalStatus = countStatus(sculpture.status);
  return sculpture;
}

// Keeps the triangles that are mapped whole, and the vertices that they use.
Sculpture collect(const Refinement& refinement, const WeldedMesh& welded, const VertexMap& map, int threads,
                  const CancelToken& token) {
  const Folds folds =
      findFolds(map, refinement.original, refinement.triangles, refinement.mapped.status, threads, token);
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  Sculpture sculpture;
  noteFolds(folds, sculpture);
  std::vector<std::uint32_t> newIndex(refinement.original.size(), unused);
  for (std::size_t i = 0; i < refinement.triangles.size(); ++i) {
    Triangle t = refinement.triangles[i];
    if (!allMapped(t, refinement.mapped.status) || isFolded(folds, i)) continue;
    for (std::uint32_t& corner : t) {
      std::uint32_t& index = newIndex[corner];
      if (index == unused) {
        index = static_cast<std::uint32_t>(sculpture.original.size());
        sculpture.mesh.positions.push_back(refinement.mapped.points[corner]);
        sculpture.original.push_back(refinement.original[corner]);
        VertexSource source = refinement.source[corner];
        source.triangle = welded.triangleOf[source.triangle];
        sculpture.source.push_back(source);
      }
      corner = index;
    }
    addTriangle(sculpture, t, welded.triangleOf[refinement.sourceTriangle[i]], folds.reversed);
  }
  sculpture.status.assign(sculpture.original.size(), PathStatus::mapped);
  sculpture.budgetHit = refinement.budgetHit;
  sculpture.remainingErrorPixels = refinement.remainingErrorPixels;
  return sculpture;
}

}  // namespace

Sculpture makeSculpture(const DeformInput& input, int threads, const Progress& progress) {
  if (!(input.tolerancePixels > 0) || input.map.mistakes.any())
    return mapOwnVertices(input, threads, progress.token);
  const WeldedMesh welded = weldPositions(*input.original);
  const Refinement refinement = refine(welded.mesh, input, threads, progress);
  if (progress.cancelled()) return {};
  Sculpture sculpture = collect(refinement, welded, input.map, threads, progress.token);
  MappedPoints own;
  mapPointsThrough(input.map, input.original->positions, own, threads);
  sculpture.originalStatus = countStatus(own.status);
  return sculpture;
}

void placeSources(const Sculpture& sculpture, const Mesh& original, PointArray& points) {
  points.resize(sculpture.source.size());
  for (std::size_t i = 0; i < sculpture.source.size(); ++i) {
    const VertexSource& source = sculpture.source[i];
    const Triangle& t = original.triangles[source.triangle];
    const PointArray& p = original.positions;
    points.set(i, (1 - source.u - source.v) * p[t[0]] + source.u * p[t[1]] + source.v * p[t[2]]);
  }
}

void remapSculpture(const VertexMap& map, Sculpture& sculpture, int threads) {
  MappedPoints mapped{std::move(sculpture.mesh.positions), std::move(sculpture.status)};
  mapPointsThrough(map, sculpture.original, mapped, threads);
  sculpture.mesh.positions = std::move(mapped.points);
  sculpture.status = std::move(mapped.status);
}

}  // namespace anamorph
