#include "panels/help_buttons.h"

#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "edit/level_helpers.h"
#include "edit/level_repairs.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

EditResult lift(const Level& level, const std::shared_ptr<const Mesh>& placed, const Progress& progress) {
  auto lifted = eyeLifted(level, placed, 1, progress);
  if (!lifted) {
    return {std::nullopt,
            tr("At this distance there is no height from which nothing is hidden. Make the original "
               "smaller, the mirror larger, or go farther away.")};
  }
  if (*lifted == level) return {std::nullopt, tr("Nothing is hidden: the eye is high enough.")};
  const double higher = lifted->camera.eye.z - level.camera.eye.z;
  return {lifted, trFormat("The eye is {:.2f} higher now, and nothing is hidden.", higher)};
}

}  // namespace

void fitOriginal(Editor& editor, UiState& ui) {
  const auto& mesh = editor.updater.result().original.mesh;
  if (!mesh) return;
  editor.session.finishChange();
  if (auto fitted = originalFittedToMirror(editor.session.level(), mesh->positions)) {
    editor.session.edit(std::move(*fitted));
  } else {
    ui.notice = Notice{
        "No size will do",
        tr("The eye does not see the middle of the original in the mirror. Put the original behind the "
           "mirror first.")};
  }
}

void fitButton(Editor& editor, UiState& ui) {
  if (wideButton(
          "Fit to the mirror",
          "As large as it can be about its middle while every vertex ray still meets the mirror, less 2 %.",
          editor.updater.result().original.mesh != nullptr)) {
    fitOriginal(editor, ui);
  }
}

void behindButton(Editor& editor) {
  if (!wideButton("Put behind the mirror",
                  "Along the line of sight, until all of it is behind the mirror as the eye sees it.")) {
    return;
  }
  editor.session.finishChange();
  const Level behind = originalMovedBehind(editor.session.level(), originalBox(editor));
  if (behind == editor.session.level()) editor.message = tr("The original is behind the mirror already.");
  editor.session.edit(behind);
}

void startLift(Editor& editor) {
  editor.session.finishChange();
  editor.job.start(editor.session, tr("Lifting the eye"),
                   [mesh = editor.updater.result().original.mesh](
                       const Level& level, const Progress& progress) { return lift(level, mesh, progress); });
}

void liftButton(Editor& editor) {
  if (editor.job.busy()) {
    const float width = ImGui::CalcTextSize(tr("Cancel")).x + 3 * ImGui::GetStyle().FramePadding.x;
    ImGui::ProgressBar(static_cast<float>(editor.job.fraction()),
                       {-width - ImGui::GetStyle().ItemSpacing.x, 0}, editor.job.name().c_str());
    ImGui::SameLine();
    if (ImGui::Button(tr("Cancel"), {-FLT_MIN, 0})) editor.job.cancel();
    return;
  }
  if (wideButton("Lift until nothing is hidden",
                 "The sculpture may stand in its own way. The eye goes up around the original, at the same "
                 "distance, "
                 "as little as is needed.",
                 editor.updater.result().original.mesh != nullptr)) {
    startLift(editor);
  }
}

}  // namespace anamorph
