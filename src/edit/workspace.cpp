#include "edit/workspace.h"

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

ViewPose rtPose(const Workspace& work) {
  return lookThroughPose(work.session.level().camera, std::max(1, work.viewWidth),
                         std::max(1, work.viewHeight));
}

// What depends on the level's parts and may be gone after an edit.
void dropStaleSelection(Workspace& work) {
  const Level& level = work.session.level();
  const int lights = static_cast<int>(level.lights.size());
  const Selection& selected = work.selection;
  if (selected.part == Part::light && (selected.index < 0 || selected.index >= lights)) work.selection = {};
  const bool inGrid =
      work.cell && work.cell->column < level.camera.gridColumns && work.cell->row < level.camera.gridRows;
  if (!inGrid) work.cell.reset();
  const auto& original = work.studio.products().original.mesh;
  if (work.point && original && !isOn(*original, *work.point)) work.point.reset();
}

bool advanceView(Workspace& work, double seconds) {
  const ViewPose before = work.pose;
  if (work.flight) {
    if (work.lookingThrough) work.flight->goal = rtPose(work);
    work.flightSeconds += seconds;
    work.pose = work.flight->poseAt(work.flightSeconds);
    if (work.flight->endedAt(work.flightSeconds)) work.flight.reset();
  } else if (work.lookingThrough) {
    work.pose = rtPose(work);
  }
  return !(before == work.pose);
}

void extendBy(Box& box, const Box& other) {
  if (other.empty()) return;
  box.extend(other.min);
  box.extend(other.max);
}

Box boxOf(const PreparedMesh& mesh) {
  return mesh.mesh ? boundingBox(mesh.mesh->positions) : Box{};
}

Box mirrorBox(const Level& level) {
  if (findShapeProblem(level.optic.shape)) return {};
  return boundingBox(tessellate(level.optic.shape).positions);
}

// Keeps what is to be found again when the session has gone from this level to another.
class Leaving {
 public:
  explicit Leaving(const Workspace& work) {
    if (!work.session.isInstalled() || !work.session.modified()) return;
    path_ = cleanPath(work.session.path());
    level_ = work.session.level();
  }
  void keep(Workspace& work, const std::filesystem::path& opened) const {
    if (!path_.empty() && path_ != opened) work.leftLevels[path_] = level_;
  }

 private:
  std::filesystem::path path_;
  Level level_;
};

}  // namespace

void openLevel(Workspace& work, const std::filesystem::path& path) {
  const Leaving leaving(work);
  work.session.open(path);
  lookAfresh(work);
  work.message = work.session.warnings().empty() ? "" : work.session.warnings().front();
  const std::filesystem::path opened = cleanPath(path);
  leaving.keep(work, opened);
  const auto left = work.leftLevels.extract(opened);
  if (left.empty()) return;
  work.session.edit(left.mapped());
  work.message = tr("As you left it. Ctrl+R: as it was.");
}

void openNewLevel(Workspace& work) {
  Leaving(work).keep(work, {});
  Level level;
  level.view = {{19, -24, 15}, {0, -3, 2}, 40};  // the RT camera is in it, too
  work.session.startNew(std::move(level));
  lookAfresh(work);
  work.message.clear();
}

void lookAfresh(Workspace& work) {
  const ViewSettings& view = work.session.level().view;
  work.pose = soundPose({view.eye, view.target, {0, 0, 1}, view.fovDegrees, false});
  work.flight.reset();
  work.lookingThrough = false;
  work.returnPose.reset();
  work.selection = {};
  work.point.reset();
  work.cell.reset();
  work.preview.tab = PreviewTab::reflection;  // the first look; and lessons wait for the others
  work.display.morph = 1;
  work.animationSeconds = 0;
}

bool advance(Workspace& work, double seconds) {
  if (auto message = work.job.update(work.session)) work.message = std::move(*message);
  dropStaleSelection(work);
  bool changed = advancePlay(work, seconds);
  changed |= advanceView(work, seconds);
  if (work.rays.animate && work.rays.show && !work.animationPaused) {
    work.animationSeconds += seconds;
    changed = true;
  }
  const bool trees = work.rays.show && (work.rays.source == RaySource::pixels || work.cell);
  const bool original = work.preview.tab != PreviewTab::reflection;
  changed |= work.studio.update(work.session, {work.preview.size, trees, original});
  return advanceLesson(work) || changed;
}

bool isMoving(const Workspace& work) {
  return work.flight || work.lesson.play || (work.rays.animate && work.rays.show && !work.animationPaused);
}

void flyTo(Workspace& work, const ViewPose& pose) {
  work.lookingThrough = false;
  work.flight = PoseFlight{work.pose, pose};
  work.flightSeconds = 0;
}

void takeOverView(Workspace& work) {
  work.flight.reset();
  work.lookingThrough = false;
}

void toggleLookThrough(Workspace& work) {
  if (work.lookingThrough) {
    flyTo(work, work.returnPose.value_or(work.pose));
    return;
  }
  work.returnPose = work.flight ? work.flight->goal : work.pose;
  flyTo(work, rtPose(work));
  work.lookingThrough = true;
}

Box originalBox(const Workspace& work) {
  return boxOf(work.studio.products().original);
}

Box sculptureBox(const Workspace& work) {
  return boxOf(work.studio.products().sculpture.prepared);
}

Box boxOf(const Workspace& work, const Selection& selection) {
  const Level& level = work.session.level();
  const Box original = originalBox(work), sculpture = sculptureBox(work);
  if (selection.part != Part::none) return boxOf(level, selection, original, sculpture);
  Box box = mirrorBox(level);
  extendBy(box, original);
  extendBy(box, sculpture);
  if (work.display.rtCamera) box.extend(level.camera.eye);
  return box;
}

std::optional<Construction> currentConstruction(const Workspace& work) {
  const Products& products = work.studio.products();
  if (!work.point || !products.original.mesh) return std::nullopt;
  if (!isOn(*products.original.mesh, *work.point)) return std::nullopt;
  if (findShapeProblem(products.level.optic.shape)) return std::nullopt;
  return makeConstruction(products.level, pointOn(*products.original.mesh, *work.point));
}

PreparedSculpture shownSculpture(Workspace& work) {
  const Products& products = work.studio.products();
  return work.morph.at(work.display.morph, products.level, products.sculpture,
                       std::min(hardwareThreads(), 4));
}

}  // namespace anamorph
