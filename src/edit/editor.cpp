#include "edit/editor.h"

#include <algorithm>
#include <utility>

#include "base/language.h"
#include "base/parallel_for.h"
#include "edit/level_edits.h"
#include "edit/level_files.h"
#include "edit/orbit.h"
#include "level/freeze.h"

namespace anamorph {
namespace {

// Keeps what is to be found again when the session has gone from this level to another.
class Leaving {
 public:
  explicit Leaving(const Editor& editor) {
    if (!editor.session.isInstalled() || !editor.session.modified()) return;
    path_ = cleanPath(editor.session.path());
    level_ = editor.session.level();
  }
  void keep(Editor& editor, const std::filesystem::path& opened) const {
    if (!path_.empty() && path_ != opened) editor.leftLevels[path_] = level_;
  }

 private:
  std::filesystem::path path_;
  Level level_;
};

const std::optional<Construction>& constructionOf(const std::optional<PickedPoint>& point,
                                                  const LevelResult& result, ConstructionStage& stage) {
  static const std::optional<Construction> none;
  if (!point || !result.source || !isOn(*result.source, *point)) return none;
  const VertexMap map = makeVertexMap(result.level);
  if (findProblem(map.optic)) return none;
  return stage.at(map, pointOn(*result.source, *point));
}

}  // namespace

void openLevel(Editor& editor, const std::filesystem::path& path) {
  openLevel(editor, readLevelFile(path));
}

void openLevel(Editor& editor, LevelFile file) {
  const Leaving leaving(editor);
  const std::filesystem::path opened = cleanPath(file.path);
  editor.session.open(std::move(file));
  lookAfresh(editor);
  editor.status.clear();
  if (!editor.session.warnings().empty()) editor.status.say(editor.session.warnings().front());
  leaving.keep(editor, opened);
  const auto left = editor.leftLevels.extract(opened);
  if (left.empty()) return;
  editor.session.edit(left.mapped());
  editor.status.sayOf(editor.session.level(), tr("As you left it. Ctrl+R: as it was."));
}

void openNewLevel(Editor& editor) {
  Leaving(editor).keep(editor, {});
  Level level;
  level.view = {{19, -24, 15}, {0, -3, 2}, 40};  // the RT camera is in it, too
  editor.session.startNew(std::move(level));
  lookAfresh(editor);
  editor.status.clear();
}

void lookAfresh(Editor& editor) {
  const ViewSettings& view = editor.session.level().view;
  editor.pose = soundPose({view.eye, view.target, {0, 0, 1}, view.fovDegrees, false});
  editor.flight.reset();
  editor.lookingThrough = false;
  editor.returnPose.reset();
  editor.selection = {};
  pickPoint(editor, {});
  editor.preview.tab = PreviewTab::reflection;  // the first look; and lessons wait for the others
  editor.display.morph = 1;
  editor.display.mirror = true;
  editor.display.alone = ShownAlone::nothing;
  restRays(editor);
}

void restRays(Editor& editor) {
  editor.rays.animate = editor.rays.sequential = editor.animationPaused = false;
  editor.animationSeconds = 0;
  editor.rayStep = 0;
}

void pickPoint(Editor& editor, const std::optional<PickedPoint>& point) {
  editor.cell.reset();
  if (!point) editor.earlierPoint.reset();
  if (point == editor.point) return;
  editor.earlierPoint = point ? editor.point : std::nullopt;
  editor.point = point;
}

void pickCell(Editor& editor, const std::optional<GridCell>& cell) {
  if (cell) pickPoint(editor, {});
  editor.cell = cell;
  editor.animationSeconds = 0;
}

bool isMoving(const Editor& editor) {
  return editor.flight || editor.lesson.play ||
         (editor.rays.animate && editor.rays.show && !editor.animationPaused);
}

void flyTo(Editor& editor, const ViewPose& pose) {
  editor.lookingThrough = false;
  editor.flight = PoseFlight{editor.pose, pose};
  editor.flightSeconds = 0;
}

void takeOverView(Editor& editor) {
  editor.flight.reset();
  editor.lookingThrough = false;
}

ViewPose rtCameraPose(const Editor& editor) {
  const Level& level = editor.session.level();
  return lookThroughPose(level.camera, level.grid, std::max(1, editor.viewWidth),
                         std::max(1, editor.viewHeight));
}

void toggleLookThrough(Editor& editor) {
  if (editor.lookingThrough) {
    flyTo(editor, editor.returnPose.value_or(editor.pose));
    return;
  }
  editor.returnPose = editor.flight ? editor.flight->goal : editor.pose;
  flyTo(editor, rtCameraPose(editor));
  editor.lookingThrough = true;
}

Box originalBox(const Editor& editor) {
  return editor.updater.result().original.box;
}

Box sculptureBox(const Editor& editor) {
  return editor.updater.result().sculpture.prepared.box;
}

Box boxOf(const Editor& editor, const Selection& selection) {
  const Level& level = editor.session.level();
  const Box original = originalBox(editor), sculpture = sculptureBox(editor);
  if (selection.part != Part::none) return boxOf(level, selection, original, sculpture);
  const DisplaySettings display = shown(editor.display);
  Box box;
  if (display.mirror) box.extend(boxOf(level.optic));
  if (display.originalLook != OriginalLook::hidden) box.extend(original);
  if (display.sculpture) box.extend(sculpture);
  if (display.rtCamera) box.extend(level.camera.eye);
  return box;
}

const std::optional<Construction>& currentConstruction(Editor& editor) {
  return constructionOf(editor.point, editor.updater.result(), editor.construction);
}

const std::optional<Construction>& earlierConstruction(Editor& editor) {
  return constructionOf(editor.earlierPoint, editor.updater.result(), editor.earlierConstruction);
}

bool canToggleFrozen(const Editor& editor) {
  const LevelResult& result = editor.updater.result();
  return editor.session.level().sculpture.frozen || (result.sculpture.sculpture && !result.problem);
}

void toggleFrozen(Editor& editor) {
  editor.session.finishChange();
  const Level& level = editor.session.level();
  editor.session.edit(level.sculpture.frozen ? following(level) : frozen(level));
}

PreparedSculpture shownSculpture(Editor& editor) {
  const LevelResult& result = editor.updater.result();
  return editor.morph.at(editor.display.morph, result.level, result.sculpture,
                         std::min(hardwareThreads(), 4));
}

}  // namespace anamorph
