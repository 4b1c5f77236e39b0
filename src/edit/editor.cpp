#include "edit/editor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/language.h"
#include "base/parallel_for.h"
#include "edit/level_edits.h"
#include "edit/level_files.h"
#include "edit/orbit.h"

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
  if (!editor.session.warnings().empty())
    editor.status.sayOf(editor.session.level(), editor.session.warnings().front());
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
  editor.point.reset();
  editor.cell.reset();
  editor.preview.tab = PreviewTab::reflection;  // the first look; and lessons wait for the others
  editor.display.morph = 1;
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
  Box box = boxOf(level.optic);
  box.extend(original);
  box.extend(sculpture);
  if (editor.display.rtCamera) box.extend(level.camera.eye);
  return box;
}

const std::optional<Construction>& currentConstruction(Editor& editor) {
  static const std::optional<Construction> none;
  const LevelResult& result = editor.updater.result();
  if (!editor.point || !result.original.mesh) return none;
  if (!isOn(*result.original.mesh, *editor.point)) return none;
  if (findProblem(result.level.optic)) return none;
  return editor.construction.at(makeVertexMap(result.level), pointOn(*result.original.mesh, *editor.point));
}

PreparedSculpture shownSculpture(Editor& editor) {
  const LevelResult& result = editor.updater.result();
  return editor.morph.at(editor.display.morph, result.level, result.sculpture,
                         std::min(hardwareThreads(), 4));
}

}  // namespace anamorph
