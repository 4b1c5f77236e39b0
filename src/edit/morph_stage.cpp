#include "edit/morph_stage.h"

#include <utility>

#include "edit/morph.h"

namespace anamorph {

MorphStage::MorphStage(std::function<void()> wake) : worker_(std::move(wake)) {}

PreparedSculpture MorphStage::at(double fraction, const LevelScene& level, const PreparedSculpture& sculpture,
                                 int threads) {
  busy_ = false;
  if (fraction >= 1 || !sculpture.sculpture || sculpture.sculpture->mesh.triangles.empty()) {
    shown_.reset();  // it is large
    return sculpture;
  }
  Input input{fraction, makeVertexMap(level), sculpture};
  if (sculpture.sculpture->mesh.positions.size() > vertexLimit) return follow(std::move(input), threads);
  return memo_.get(std::move(input), [&](const Input& in) { return maker_.make(in, threads); });
}

// A state that is begun is finished though another one is wanted by now: else nothing would be seen of a slider that
// is dragged.
PreparedSculpture MorphStage::follow(Input input, int threads) {
  if (auto state = states_->take()) shown_ = std::move(*state);
  const PreparedSculpture sculpture = input.sculpture;
  if (worker_.takeFailure()) failed_ = requested_;  // out of memory: the same again would fail again
  busy_ = !(shown_ && shown_->input == input) && !(failed_ && *failed_ == input);
  if (busy_ && !worker_.busy()) {
    requested_ = input;
    worker_.request(
        [input = std::move(input), threads, maker = workersMaker_, states = states_](const Progress&) {
          states->put({input, maker->make(input, threads)});
        });
  }
  return shown_ && shown_->input.sculpture == sculpture ? shown_->made : sculpture;
}

PreparedSculpture MorphStage::Maker::make(const Input& input, int threads) {
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
