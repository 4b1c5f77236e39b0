#include "edit/morph_stage.h"

#include "edit/morph.h"
#include "pipeline/live.h"

namespace anamorph {

PreparedSculpture MorphStage::at(double fraction, const Level& level, const PreparedSculpture& sculpture,
                                 int threads) {
  if (fraction >= 1 || !sculpture.sculpture || sculpture.sculpture->mesh.triangles.empty()) return sculpture;
  return memo_.get({fraction, level.optic, level.camera.eye, sculpture},
                   [&](const Input& input) { return make(input, threads); });
}

PreparedSculpture MorphStage::make(const Input& input, int threads) {
  const PreparedMesh& prepared = input.sculpture.prepared;
  if (ringGroups_ != prepared.normalGroups) {
    ringGroups_ = prepared.normalGroups;
    ring_ = {};
  }
  const Sculpture& goal = *input.sculpture.sculpture;
  const auto moving = ring_.take({goal, *prepared.bvh, *prepared.normals});
  Sculpture& sculpture = moving->sculpture;
  sculpture.original = goal.original;
  sculpture.status = goal.status;
  sculpture.originalStatus = goal.originalStatus;
  sculpture.mesh.positions = morphPoints(goal, input.optic, input.eye, input.fraction, threads);
  const Mesh& mesh = sculpture.mesh;
  moving->normals = computeNormals(mesh.positions, mesh.triangles, *prepared.normalGroups, threads);
  moving->bvh.refit(mesh.positions, threads, absentPoints(sculpture.status));
  return {
      {moving, &sculpture},
      {{moving, &sculpture.mesh}, {moving, &moving->bvh}, prepared.normalGroups, {moving, &moving->normals}}};
}

}  // namespace anamorph
