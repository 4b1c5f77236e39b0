// The stages from a level to its pictures and figures. Each takes the values it depends on and nothing else;
// window, commands and tests call these and no others.
//
//   Level, original --> DeformInput --makeSculpture--> Sculpture --> MatchInput --computeMatch--> Match
//                                                               `--> SceneInput --render--> Image
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "anamorphosis/match.h"
#include "anamorphosis/sculpture.h"
#include "level/level.h"
#include "raytrace/scene.h"

namespace anamorph {

/// A mesh with what tracing and shading it need, made once.
struct PreparedMesh {
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const Bvh> bvh;
  std::shared_ptr<const NormalGroups> normalGroups;
  std::shared_ptr<const std::vector<glm::vec3>> normals;
  Box box;  ///< of its positions

  bool operator==(const PreparedMesh&) const = default;
};

struct PreparedSculpture {
  std::shared_ptr<const Sculpture> sculpture;
  PreparedMesh prepared;

  bool operator==(const PreparedSculpture&) const = default;
};

/// What became of a ray with this status, and what to do about it: sentences without the first capital letter
/// and the last full stop.
const char* explainStatus(PathStatus status);

/// Why the level cannot be computed at all (a broken mirror, the eye inside it, the eye in the original's box), in
/// a sentence for the student; nothing when it can.
std::optional<std::string> findProblem(const LevelScene& level, const Box& original);

/// Where in a level's file that is, as a JSON pointer: of the mirror, the eye or the original.
const char* placeOfProblem(const LevelScene& level);

/// The same of what the level's sculpture is made from, the original (`source`) included: another question only while
/// it is frozen.
std::optional<std::string> findSculptureProblem(const LevelScene& level, const Box& source);

/// Why no triangle of the original that has an area has come into the sculpture; nothing when some have.
std::optional<std::string> findEmptiness(const Sculpture& sculpture);

/// What is shown then: a sculpture without triangles that knows what became of the original's vertices.
PreparedSculpture emptySculpture(const StatusCounts& counts);

/// "6100 of 6146 vertices mapped (46 miss the mirror)"
std::string statusSentence(const StatusCounts& counts);
/// The same in the chosen language.
std::string shownStatus(const StatusCounts& counts);

/// What is worth knowing of a sculpture that is not empty: vertices that are not mapped, a budget that was
/// hit, parts below the ground, that it is frozen.
std::vector<std::string> findWarnings(const LevelScene& level, const PreparedSculpture& sculpture);

/// That the sculpture is frozen, and for which eye it was made; nothing when it follows.
std::optional<std::string> frozenSentence(const LevelScene& level);

/// The map that the level's sculpture is made by.
VertexMap makeVertexMap(const LevelScene& level);

/// `source` is the original in scene coordinates, where it stands or, for a frozen sculpture, stood.
DeformInput makeDeformInput(const LevelScene& level, std::shared_ptr<const Mesh> source);

PreparedMesh prepareMesh(std::shared_ptr<const Mesh> mesh, int threads = 1);

/// Which corners are shaded together is decided on the original's shape, which has the sharp edges; the
/// curved sculpture keeps them.
PreparedSculpture prepareSculpture(Sculpture sculpture, int threads = 1);

/// "0.25 px"; farthestContour is "16 px or more". In the chosen language.
std::string contourText(double pixels);

/// Why a match has no grade, and what to do about it; nothing when it has.
std::optional<std::string> findMatchProblem(const MatchReport& report);

MatchInput makeMatchInput(const LevelScene& level, const PreparedMesh& original,
                          const PreparedSculpture& sculpture, int width, int height);

/// What the RT camera sees of the finished work: mirror, sculpture, ground; not the original. A broken mirror
/// is left out.
SceneInput makeReflectionScene(const LevelScene& level, const PreparedSculpture& sculpture);

/// The reference: the original alone, seen directly.
SceneInput makeOriginalScene(const LevelScene& level, const PreparedMesh& original);

}  // namespace anamorph
