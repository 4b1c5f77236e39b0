#include "optics/mesh_mirror.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "base/language.h"

namespace anamorph {
namespace {

/// `v` with length 1; `otherwise` where it has none.
Direction unitOr(const Vector& v, const Direction& otherwise) {
  const double length = glm::length(v);
  return length > 0 ? v / length : otherwise;
}

// Normals go as planes do: by the inverse of the scale.
SmoothMesh placed(const SmoothMesh& surface, const Placement& placement) {
  if (placement == Placement{}) return surface;
  SmoothMesh result;
  result.mesh.triangles = surface.mesh.triangles;
  result.mesh.positions = mapPoints(surface.mesh.positions, PlacementMap(placement));
  const glm::dmat3 turn = rotationMatrix(placement.rotationDegrees);
  result.normals = mapPoints(surface.normals, [&](const Vector& n) {
    return unitOr(turn * (n / placement.scale), Direction(0, 0, 1));
  });
  result.corners = surface.corners;
  return result;
}

}  // namespace

void MeshMirror::visitFields(ShapeFields& fields) {
  fields.file({"path", "File", "The mesh file that the mirror's surface is in."}, file);
  fields.point({"position", "Position", "Where the file's origin is.", false, true}, placement.position);
  fields.angles({"rotationDegrees", "Rotation", "In degrees about x, then y, then z.", false, true},
                placement.rotationDegrees);
  fields.lengths({"scale", "Scale", "How much larger than in the file, along its x, y and z.", false, true},
                 {&placement.scale.x, 3});
}

MeshMirror::Prepared MeshMirror::prepare() const {
  Prepared prepared;
  prepared.box.extend(prepared.middle = placement.position);
  if (findProblem()) return prepared;
  prepared.surface = placed(*file.mesh, placement);
  const Mesh& mesh = prepared.surface.mesh;
  prepared.tree = Bvh(mesh.positions, mesh.triangles, 0);
  prepared.box = boundingBox(mesh.positions);
  prepared.middle = PlacementMap(placement)(boundingBox(file.mesh->mesh.positions).centre());
  return prepared;
}

std::optional<SurfaceHit> MeshMirror::intersect(const Prepared& prepared, const Ray& ray, double tMin) const {
  BvhHit met;
  if (!prepared.tree.closestExactHit(ray, met, tMin)) return std::nullopt;
  const SmoothMesh& surface = prepared.surface;
  const Triangle &corners = surface.mesh.triangles[met.triangle], &normals = surface.normalsOf(met.triangle);
  const auto mean = [&](const PointArray& values, const Triangle& at) {
    return (1 - met.u - met.v) * values[at[0]] + met.u * values[at[1]] + met.v * values[at[2]];
  };
  const Direction facet = unitOr(areaVector(surface.mesh.positions, corners), Direction(0));
  const Direction normal = unitOr(mean(surface.normals, normals), facet);
  return SurfaceHit{met.t, mean(surface.mesh.positions, corners), facing(normal, ray.direction), facet};
}

std::optional<std::string> MeshMirror::findProblem() const {
  if (!file.problem.empty()) return file.problem;
  if (file.path.empty()) return tr("expected the name of a mesh file");
  if (!file.mesh) return tr("its mesh file has not been read");
  const std::size_t triangles = file.mesh->mesh.triangles.size();
  if (triangles == 0) return tr("expected a mesh with triangles, got one without");
  if (triangles > mostTriangles) {
    return trFormat("expected a mesh of at most {} triangles, got {}; make it coarser", mostTriangles,
                    triangles);
  }
  return std::nullopt;
}

std::optional<std::string> MeshMirror::findEyeProblem(const Prepared& prepared, const Point& eye) const {
  return findDistanceProblem(glm::length(eye - prepared.middle), 0.5 * prepared.box.diagonal());
}

Point MeshMirror::eyeOutside(const Prepared& prepared, const Point& eye, const Point& original) const {
  return prepared.middle +
         prepared.box.diagonal() * wayOut(eye - prepared.middle, prepared.middle - original, {0, -1, 0});
}

Axes MeshMirror::axes() const {
  const glm::dmat3 turn = rotationMatrix(placement.rotationDegrees);
  return {turn[0], turn[1], turn[2]};
}

ShapeExtent MeshMirror::extent(const Prepared& prepared) const {
  const Vector size = prepared.box.size();
  return {prepared.box.centre(), {0, 0, 1}, std::max(size.x, size.y), size.z};
}

MeshMirror MeshMirror::filling(const ShapeExtent& room, const Point&) {
  return {{}, {.position = room.middle}};
}

void MeshMirror::map(const ShapeMap& map) {
  const Point origin = map.point(placement.position);
  glm::dmat3 turned;
  const Axes before = axes();
  for (int i = 0; i < 3; ++i) {
    placement.scale[i] = map.size(placement.scale[i], map.factors[i]);
    turned[i] = unitOr(map.point(placement.position + before[i]) - origin, before[i]);
  }
  placement.rotationDegrees = eulerDegrees(turned, placement.rotationDegrees);
  placement.position = origin;
}

void MeshMirror::carryOn() {
  constexpr double growth = 1.05;
  if (!file.mesh) return;
  const Point middle = PlacementMap(placement)(boundingBox(file.mesh->mesh.positions).centre());
  placement.scale *= growth;
  placement.position = middle + growth * (placement.position - middle);
}

Point MeshMirror::pointAt(const Prepared& prepared, double u, double v) const {
  const Mesh& mesh = prepared.surface.mesh;
  if (mesh.triangles.empty()) return prepared.middle;
  const auto count = static_cast<double>(mesh.triangles.size());
  const Triangle& t = mesh.triangles[static_cast<std::size_t>(std::clamp(u * count, 0.0, count - 1))];
  const Point opposite = 0.5 * (mesh.positions[t[1]] + mesh.positions[t[2]]);
  return glm::mix(mesh.positions[t[0]], opposite, v);
}

SmoothMesh MeshMirror::tessellate(const Prepared& prepared, int) const {
  return prepared.surface;
}

ShapeWords MeshMirror::words(const Prepared& prepared, LengthText text) const {
  const Vector size = prepared.box.size();
  return {
      trFormat("The surface of {}, {} x {} x {} mm. ", std::filesystem::path(file.path).filename().string(),
               text(size.x), text(size.y), text(size.z)),
      tr("Over the blue outline, turned as it is drawn")};
}

}  // namespace anamorph
