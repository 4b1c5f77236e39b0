#include "panels/help_buttons.h"

#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "edit/level_helpers.h"
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
  const Vector way = lifted->camera.eye - level.camera.eye;
  const double aside = std::hypot(way.x, way.y);
  if (aside < 0.005) return {lifted, trFormat("The eye is {:.2f} higher now, and nothing is hidden.", way.z)};
  return {lifted,
          trFormat("The eye is {:.2f} higher now and {:.2f} nearer over the ground, and nothing is hidden.",
                   way.z, aside)};
}

EditResult fit(const Level& level, const std::shared_ptr<const Mesh>& placed, const Progress& progress) {
  auto fitted = originalFittedToMirror(level, placed, 1, progress);
  if (!fitted) {
    return {std::nullopt,
            tr("No size will do here. Put the original behind the mirror first, or move the eye so "
               "that it sees the middle of the original in the mirror.")};
  }
  if (*fitted == level)
    return {std::nullopt, tr("It cannot be larger without something being hidden or missed.")};
  const double factor =
      glm::length(fitted->original.placement.scale) / glm::length(level.original.placement.scale);
  return {fitted, trFormat("The original is {:.3g} times as large now.", factor)};
}

EditResult putBehind(const Level& level, const std::shared_ptr<const Mesh>& placed,
                     const Progress& progress) {
  auto behind = originalPutBehind(level, placed, 1, progress);
  if (!behind) {
    return {
        std::nullopt,
        tr("Nowhere along the line of sight is more of it seen in the mirror. Make the original smaller or "
           "the mirror larger, or turn the eye to the mirror's middle.")};
  }
  if (*behind == level)
    return {std::nullopt, tr("The original is behind the mirror already, and all of it is seen.")};
  return {behind, tr("The original is behind the mirror now.")};
}

// What a button finds for a level and its placed original.
using Search = EditResult (*)(const Level&, const std::shared_ptr<const Mesh>&, const Progress&);

void startSearch(Editor& editor, const char* name, Search search) {
  editor.session.finishChange();
  editor.job.start(
      editor.session, name,
      [search, mesh = editor.updater.result().original.mesh](const Level& level, const Progress& progress) {
        return search(level, mesh, progress);
      });
}

// How far the job is, which the status line can cancel; whether it runs.
bool jobProgress(const Editor& editor) {
  if (!editor.job.busy()) return false;
  ImGui::ProgressBar(static_cast<float>(editor.job.fraction()), {-FLT_MIN, 0}, editor.job.name().c_str());
  return true;
}

// Its sculpture would not follow, so moving the eye or the original could only spoil what it shows.
bool searchButton(const Editor& editor, const char* name, const char* help, bool usable = true) {
  const bool frozen = editor.session.level().sculpture.frozen.has_value();
  return wideButton(name, frozen ? "The sculpture is frozen: let it follow again first." : help,
                    usable && !frozen && editor.updater.result().original.mesh != nullptr);
}

}  // namespace

void startFit(Editor& editor) {
  startSearch(editor, tr("Fitting the original"), fit);
}

void startBehind(Editor& editor) {
  startSearch(editor, tr("Putting it behind the mirror"), putBehind);
}

void startLift(Editor& editor) {
  startSearch(editor, tr("Lifting the eye"), lift);
}

void originalButtons(Editor& editor) {
  if (jobProgress(editor)) {
    ImGui::Dummy({0, ImGui::GetFrameHeight()});  // of the second button: nothing moves under the mouse
    return;
  }
  if (searchButton(editor, "Fit to the mirror",
                   "As large as it can be about its middle while all of it is seen in the mirror and nothing "
                   "is hidden, less 2 %.")) {
    startFit(editor);
  }
  if (searchButton(editor, "Put behind the mirror",
                   "Along the line of sight, to where all of it is behind the mirror and nothing of it is "
                   "hidden or missed; else to where most of it is seen.")) {
    startBehind(editor);
  }
}

void liftButton(Editor& editor) {
  if (jobProgress(editor)) return;
  if (searchButton(editor, "Lift until nothing is hidden",
                   "The sculpture may stand in its own way. The eye goes up around the original, at the same "
                   "distance, as little as is needed.",
                   !editor.updater.result().problem)) {  // whose reason is another one than height
    startLift(editor);
  }
}

}  // namespace anamorph
