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

// From the file into the scene. Normals go as planes do: by the inverse of the scale.
Direction placedNormal(const Placement& placement, const glm::dmat3& turn, const Vector& normal,
                       const Direction& otherwise) {
  return unitOr(turn * (normal / placement.scale), otherwise);
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
  prepared.turn = rotationMatrix(placement.rotationDegrees);
  prepared.box.extend(prepared.middle = placement.position);
  if (findProblem()) return prepared;
  const Mesh& mesh = file.mesh->mesh;
  const PlacementMap place(placement);
  prepared.tree = file.tree ? file.tree : std::make_shared<const Bvh>(mesh.positions, mesh.triangles, 0);
  prepared.box = boundingBox(mapPoints(mesh.positions, place));
  prepared.middle = place(boundingBox(mesh.positions).centre());
  return prepared;
}

std::optional<SurfaceHit> MeshMirror::intersect(const Prepared& prepared, const Ray& ray, double tMin) const {
  if (!prepared.tree) return std::nullopt;
  const auto intoFile = [&](const Vector& v) { return glm::transpose(prepared.turn) * v / placement.scale; };
  BvhHit met;
  const Ray inFile{intoFile(ray.origin - placement.position), intoFile(ray.direction)};
  if (!prepared.tree->closestExactHit(inFile, met, tMin)) return std::nullopt;
  const Mesh& mesh = file.mesh->mesh;
  const Triangle &corners = mesh.triangles[met.triangle], &normals = file.mesh->normalsOf(met.triangle);
  const auto mean = [&](const Vector& a, const Vector& b, const Vector& c) {
    return (1 - met.u - met.v) * a + met.u * b + met.v * c;
  };
  const auto normalAt = [&](std::uint32_t i) {
    return placedNormal(placement, prepared.turn, file.mesh->normals[i], Direction(0));
  };
  const Point point =
      mean(mesh.positions[corners[0]], mesh.positions[corners[1]], mesh.positions[corners[2]]);
  const Direction facet =
      placedNormal(placement, prepared.turn, areaVector(mesh.positions, corners), Direction(0));
  const Direction normal =
      unitOr(mean(normalAt(normals[0]), normalAt(normals[1]), normalAt(normals[2])), facet);
  return SurfaceHit{met.t, placement.position + prepared.turn * (placement.scale * point),
                    facing(normal, ray.direction), facet};
}

std::optional<std::string> MeshMirror::findProblem() const {
  if (!file.problem.empty()) return file.problem;
  if (file.path.empty()) return tr("expected the name of a mesh file");
  if (!file.mesh) return tr("its mesh file has not been read");
  const std::size_t triangles = file.mesh->mesh.triangles.size();
  if (triangles == 0) return tr("expected a mesh with triangles, got one without");
  if (triangles > SurfaceFile::mostTriangles) {
    return trFormat("expected a mesh of at most {} triangles, got {}; make it coarser",
                    SurfaceFile::mostTriangles, triangles);
  }
  return std::nullopt;
}

std::optional<std::string> MeshMirror::findEyeProblem(const Prepared& prepared, const Point& eye) const {
  const double size = 0.5 * prepared.box.diagonal(), near = shapeTolerance * size;
  if (auto problem = findDistanceProblem(glm::length(eye - prepared.middle), size, "size")) return problem;
  // Near a surface one of these directions meets it within twice the distance.
  for (const Direction& axis : sceneAxes) {
    for (const double sign : {-1.0, 1.0}) {
      const auto hit = intersect(prepared, {eye, sign * axis}, -near);
      if (hit && hit->t <= near) return findContactProblem(0, 1);
    }
  }
  return std::nullopt;
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

Point MeshMirror::pointAt(double u, double v) const {
  if (findProblem()) return placement.position;
  const Mesh& mesh = file.mesh->mesh;
  const auto count = static_cast<double>(mesh.triangles.size());
  const Triangle& t = mesh.triangles[static_cast<std::size_t>(std::clamp(u * count, 0.0, count - 1))];
  const Point opposite = 0.5 * (mesh.positions[t[1]] + mesh.positions[t[2]]);
  return PlacementMap(placement)(glm::mix(mesh.positions[t[0]], opposite, v));
}

SmoothMesh MeshMirror::tessellate(int) const {
  if (findProblem()) return {};
  if (placement == Placement{}) return *file.mesh;
  SmoothMesh surface = *file.mesh;
  surface.mesh.positions = mapPoints(file.mesh->mesh.positions, PlacementMap(placement));
  const glm::dmat3 turn = rotationMatrix(placement.rotationDegrees);
  surface.normals = mapPoints(file.mesh->normals, [&](const Vector& n) {
    return placedNormal(placement, turn, n, Direction(0, 0, 1));
  });
  return surface;
}

ShapeWords MeshMirror::words(const Prepared& prepared, LengthText text) const {
  const Vector size = prepared.box.size();
  return {
      trFormat("The surface of {}, {} x {} x {} mm. ", std::filesystem::path(file.path).filename().string(),
               text(size.x), text(size.y), text(size.z)),
      tr("Over the blue outline, turned as it is drawn")};
}

}  // namespace anamorph
