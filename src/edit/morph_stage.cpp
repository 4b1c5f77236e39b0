#include "edit/morph_stage.h"

#include "edit/morph.h"

namespace anamorph {

PreparedSculpture MorphStage::at(double fraction, const LevelScene& level, const PreparedSculpture& sculpture,
                                 int threads) {
  if (fraction >= 1 || !sculpture.sculpture || sculpture.sculpture->mesh.triangles.empty()) return sculpture;
  return memo_.get({fraction, makeVertexMap(level), sculpture},
                   [&](const Input& input) { return make(input, threads); });
}

PreparedSculpture MorphStage::make(const Input& input, int threads) {
  const PreparedMesh& prepared = input.sculpture.prepared;
  if (ringGroups_ != prepared.normalGroups) {
    ringGroups_ = prepared.normalGroups;
    ring_ = {};
  }
  const Sculpture& goal = *input.sculpture.sculpture;
  const auto moving = ring_.take([&] { return MovingMesh{goal, *prepared.bvh, *prepared.normals}; });
  Sculpture& sculpture = moving->sculpture;
  sculpture.original = goal.original;
  sculpture.status = goal.status;
  sculpture.originalStatus = goal.originalStatus;
  sculpture.mesh.positions = morphPoints(goal, input.map, input.fraction, threads);
  return finishSculptureMove(moving, prepared.normalGroups, threads);
}

}  // namespace anamorph
