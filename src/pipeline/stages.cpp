#include "pipeline/stages.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "anamorphosis/contour.h"
#include "base/language.h"
#include "level/freeze.h"

namespace anamorph {
namespace {

MeshSurface surfaceOf(std::string name, const PreparedMesh& mesh, const Material& material) {
  return {std::move(name), mesh.mesh, mesh.box, mesh.bvh, mesh.normalGroups, mesh.normals, material};
}

bool contains(const Box& box, const Point& p) {
  return !box.empty() && glm::min(box.min, p) == box.min && glm::max(box.max, p) == box.max;
}

std::optional<std::string> findProblemOf(const Optic& optic, const Point& eye, const Box& original) {
  if (auto problem = findProblem(optic)) return problem;
  if (auto problem = findEyeProblem(optic, eye)) return problem;
  if (contains(original, eye)) {
    return tr(
        "the eye is inside the original's box, so it cannot see the original as a whole. Move the eye, or "
        "the original behind the mirror.");
  }
  if (!isFinite(original.min) || !isFinite(original.max))
    return tr("the original has coordinates that are not finite.");
  return std::nullopt;
}

// Corners are shaded together by where they were on `shape` (null: the mesh itself). Files repeat positions
// along texture seams, which are no edges: joined here, with all triangles kept.
NormalGroups shadingGroups(const Mesh& mesh, const PointArray* shape) {
  const Mesh unfolded{shape ? *shape : mesh.positions, mesh.triangles};
  WeldedMesh welded = weldPositions(unfolded);
  welded.mesh.triangles = mesh.triangles;
  for (Triangle& t : welded.mesh.triangles) {
    for (std::uint32_t& corner : t) corner = welded.vertexOf[corner];
  }
  return makeNormalGroups(welded.mesh);
}

PreparedMesh prepare(std::shared_ptr<const Mesh> mesh, const PointArray* shape, int threads) {
  PreparedMesh prepared;
  NormalGroups groups = shadingGroups(*mesh, shape);
  prepared.bvh = std::make_shared<const Bvh>(mesh->positions, mesh->triangles, threads);
  prepared.normals = std::make_shared<const std::vector<glm::vec3>>(
      computeNormals(mesh->positions, mesh->triangles, groups, threads));
  prepared.normalGroups = std::make_shared<const NormalGroups>(std::move(groups));
  prepared.box = boundingBox(mesh->positions);
  prepared.mesh = std::move(mesh);
  return prepared;
}

// A live sculpture has triangles with corners that are not mapped: nothing is seen of those.
bool hasArea(const Sculpture& sculpture) {
  const auto mapped = [&](std::uint32_t corner) { return sculpture.status[corner] == PathStatus::mapped; };
  const auto& triangles = sculpture.mesh.triangles;
  return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return mapped(t[0]) && mapped(t[1]) && mapped(t[2]) && areaVector(sculpture.original, t) != Vector(0);
  });
}

std::size_t totalOf(const StatusCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

// How many are mapped, and why the others are not; `in` gives the language.
std::string statusIn(const std::string& mapped, const StatusCounts& counts,
                     const char* (*in)(const char* english)) {
  std::string rest;
  for (std::size_t i = 1; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    rest += fmt::format("{}{} {}", rest.empty() ? "" : ", ", counts[i],
                        in(pathStatusWords(static_cast<PathStatus>(i))));
  }
  return rest.empty() ? mapped : mapped + " (" + rest + ")";
}

// What was left out because the rays had crossed, and the two ways out.
std::optional<std::string> foldSentence(const LeftOutFolds& folded) {
  if (folded.triangles == 0) return std::nullopt;
  const std::string share = shownFormat("{:.2g} %", 100 * folded.share);
  const FocusRange& foci = folded.foci;
  if (foci.none()) return trFormat("{} of the sculpture is folded and left out", share);
  const std::string where = foci.farthest > 1.05 * foci.nearest
                                ? trFormat("between {:.3g} and {:.3g}", foci.nearest, foci.farthest)
                                : shownFormat("{:.3g}", foci.nearest);
  return trFormat(
      "{} of the sculpture is folded and left out: its rays cross {} before the mirror. Bring all of it "
      "nearer "
      "than that with the depth scale, or all of it beyond with the depth offset",
      share, where);
}

}  // namespace

const char* explainStatus(PathStatus status) {
  switch (status) {
    case PathStatus::mapped:
      break;
    case PathStatus::missesMirror:
      return tr(
          "the ray from the eye through the vertex never meets the mirror. Make the mirror larger, or move "
          "the original to where the eye sees the mirror in front of it");
    case PathStatus::inFrontOfMirror:
      return tr(
          "the vertex is between the eye and the mirror. Move the original behind the mirror, away from the "
          "eye");
    case PathStatus::grazing:
      return tr("the ray only grazes the mirror. Move the original towards the middle of the mirror");
    case PathStatus::hitsMirrorAgain:
      return tr(
          "the reflected ray meets the mirror a second time. Use the outside of the mirror, or a smaller "
          "depth scale");
  }
  return tr("nothing is wrong");
}

std::optional<std::string> findProblem(const LevelScene& level, const Box& original) {
  return findProblemOf(level.optic, level.camera.eye, original);
}

const char* placeOfProblem(const LevelScene& level) {
  if (findProblem(level.optic)) return "/optic/shape";
  return findEyeProblem(level.optic, level.camera.eye) ? "/camera/eye" : "/original";
}

std::optional<std::string> findSculptureProblem(const LevelScene& level, const Box& source) {
  const SculptureInputs inputs = sculptureInputs(level);
  return findProblemOf(inputs.optic, inputs.camera.eye, source);
}

std::optional<std::string> findEmptiness(const Sculpture& sculpture) {
  if (hasArea(sculpture)) return std::nullopt;
  const StatusCounts& counts = sculpture.originalStatus;
  const std::size_t total = totalOf(counts);
  const auto worst = std::max_element(counts.begin() + 1, counts.end());
  if (*worst == 0)
    return tr("no triangle of the original has an area, so there is nothing to see in the mirror.");
  return trFormat("no triangle of the original can be mapped. For {} of its {} vertices, {}.", *worst, total,
                  explainStatus(static_cast<PathStatus>(worst - counts.begin())));
}

PreparedSculpture emptySculpture(const StatusCounts& counts) {
  Sculpture empty;
  empty.originalStatus = counts;
  return prepareSculpture(std::move(empty));
}

std::string statusSentence(const StatusCounts& counts) {
  const std::string mapped = fmt::format("{} of {} vertices mapped", counts[0], totalOf(counts));
  return statusIn(mapped, counts, [](const char* english) { return english; });
}

std::string shownStatus(const StatusCounts& counts) {
  const std::string mapped = trFormat("{} of {} vertices mapped", counts[0], totalOf(counts));
  return statusIn(mapped, counts, [](const char* english) { return tr(english); });
}

std::vector<std::string> findWarnings(const LevelScene& level, const PreparedSculpture& prepared) {
  const Sculpture& sculpture = *prepared.sculpture;
  std::vector<std::string> warnings;
  const StatusCounts& counts = sculpture.originalStatus;
  if (std::any_of(counts.begin() + 1, counts.end(), [](std::size_t count) { return count > 0; })) {
    const bool ownVertices = level.sculpture.tolerancePixels == 0;
    const std::string status = shownStatus(counts);
    warnings.push_back(ownVertices ? trFormat("{}; faces with an unmapped corner are left out, their "
                                              "vertices keep the original's position",
                                              status)
                                   : trFormat("{}; faces with an unmapped corner are left out", status));
  }
  if (sculpture.budgetHit) {
    warnings.push_back(
        trFormat("refinement stopped at the budget of {} triangles, where an edge is still {:.2g} px "
                 "off; raise maxTriangles in the level, or the tolerance",
                 level.sculpture.maxTriangles, sculpture.remainingErrorPixels));
  }
  if (const auto folds = foldSentence(sculpture.folded)) warnings.push_back(*folds);
  const double lowest = prepared.prepared.box.min.z;
  if (level.ground.visible && lowest < level.ground.height - 1e-9) {
    warnings.push_back(
        trFormat("the sculpture reaches {:.3g} below the ground, where pictures do not show it; raise "
                 "the original, change the depth scale, or hide the ground",
                 level.ground.height - lowest));
  }
  if (const auto frozen = frozenSentence(level)) warnings.push_back(*frozen);
  return warnings;
}

std::optional<std::string> frozenSentence(const LevelScene& level) {
  if (!level.sculpture.frozen) return std::nullopt;
  const Point& eye = level.sculpture.frozen->camera.eye;
  return trFormat("the sculpture is frozen as it was made for the eye at ({:g}, {:g}, {:g})", eye.x, eye.y,
                  eye.z);
}

VertexMap makeVertexMap(const LevelScene& level) {
  const SculptureInputs inputs = sculptureInputs(level);
  return {inputs.optic, inputs.camera.eye, inputs.depthScale, inputs.depthOffset, inputs.mistakes};
}

DeformInput makeDeformInput(const LevelScene& level, std::shared_ptr<const Mesh> source) {
  DeformInput input;
  input.original = std::move(source);
  input.map = makeVertexMap(level);
  input.camera = sculptureInputs(level).camera;
  input.imageSize = level.sculpture.imageSize;
  input.tolerancePixels = level.sculpture.tolerancePixels;
  input.maxTriangles = level.sculpture.maxTriangles;
  return input;
}

PreparedMesh prepareMesh(std::shared_ptr<const Mesh> mesh, int threads) {
  return prepare(std::move(mesh), nullptr, threads);
}

PreparedSculpture prepareSculpture(Sculpture sculpture, int threads) {
  const auto shared = std::make_shared<const Sculpture>(std::move(sculpture));
  const std::shared_ptr<const Mesh> mesh(shared,
                                         &shared->mesh);  // the same object, kept alive by the sculpture
  return {shared, prepare(mesh, &shared->original, threads)};
}

std::string contourText(double pixels) {
  if (pixels < farthestContour) return shownFormat("{:.2f} px", pixels);
  return trFormat("{:g} px or more", farthestContour);
}

std::optional<std::string> findMatchProblem(const MatchReport& report) {
  if (gradeOf(report) != MatchGrade::tooSmall) return std::nullopt;
  if (report.originalPixels == 0) {
    return tr(
        "from this eye the original covers no pixel: turn the eye to it, or move one of them so that it "
        "is not seen edge-on");
  }
  if (report.originalPixels == 1)
    return tr("from this eye the original covers 1 pixel: come nearer or narrow the field of view");
  return trFormat("from this eye the original covers {} pixels: come nearer or narrow the field of view",
                  report.originalPixels);
}

MatchInput makeMatchInput(const LevelScene& level, const PreparedMesh& original,
                          const PreparedSculpture& sculpture, int width, int height) {
  MatchInput input;
  input.original = original.mesh;
  input.originalBvh = original.bvh;
  input.sculpture = sculpture.sculpture;
  input.sculptureBvh = sculpture.prepared.bvh;
  input.optic = level.optic;
  input.camera = level.camera;
  input.originalMoved = hasOriginalMoved(level);
  const SceneInput scene = makeReflectionScene(level, sculpture);
  if (scene.ground) input.floor = floorOf(*scene.ground, measureScene(boxOf(scene)));
  input.width = width;
  input.height = height;
  return input;
}

SceneInput makeReflectionScene(const LevelScene& level, const PreparedSculpture& sculpture) {
  SceneInput scene;
  scene.surfaces.push_back(surfaceOf("sculpture", sculpture.prepared, level.sculpture.material));
  if (isShown(level.optic)) {
    scene.optic = OpticSurface{level.optic, level.mirrorLook.tint, level.mirrorLook.reflectance};
  }
  if (level.ground.visible) {
    scene.ground.emplace();
    scene.ground->height = level.ground.height;
  }
  scene.lights = level.lights;
  scene.background = level.background;
  return scene;
}

SceneInput makeOriginalScene(const LevelScene& level, const PreparedMesh& original) {
  SceneInput scene;
  scene.surfaces.push_back(surfaceOf("original", original, level.original.material));
  scene.lights = level.lights;
  scene.background = level.background;
  return scene;
}

}  // namespace anamorph
