#include "app/state_log.h"

#include <array>
#include <initializer_list>
#include <limits>

#include <imgui.h>

#include "base/error.h"
#include "cli/report.h"
#include "edit/session.h"
#include "panels/dialogs.h"

namespace anamorph {
namespace {

JsonValue listOf(std::initializer_list<double> numbers) {
  JsonValue list = emptyList();
  for (const double number : numbers) {
    list.items.push_back(JsonObject().add("", number).value().items.front());
  }
  return list;
}

JsonValue rectJson(const Rect& r) {
  return listOf({r.x, r.y, r.width, r.height});
}

const char* nameOf(Part part) {
  constexpr std::array names{"none", "eye", "aim", "original", "mirror", "sculpture", "light"};
  return names.at(static_cast<std::size_t>(part));
}

JsonValue poseJson(const ViewPose& pose) {
  return JsonObject()
      .add("eye", pose.eye)
      .add("target", pose.target)
      .add("up", pose.up)
      .add("fovDegrees", pose.fovDegrees)
      .add("orthographic", pose.orthographic)
      .value();
}

JsonValue countsJson(const InputCounts& counts) {
  return JsonObject()
      .add("keysDown", counts.keysDown)
      .add("keysUp", counts.keysUp)
      .add("characters", counts.characters)
      .add("buttonsDown", counts.buttonsDown)
      .add("buttonsUp", counts.buttonsUp)
      .add("wheel", counts.wheel)
      .add("motions", counts.motions)
      .value();
}

void addLevel(JsonObject& line, const Editor& editor) {
  const Level& level = editor.session.level();
  line.add("level", editor.session.path().string())
      .add("eye", level.camera.eye)
      .add("target", level.camera.target)
      .add("original", level.original.placement.position)
      .add("depthScale", level.sculpture.depthScale)
      .add("depthOffset", level.sculpture.depthOffset)
      .add("frozen", level.sculpture.frozen.has_value())
      .add("modified", editor.session.modified())
      .add("changing", editor.session.changing())
      .add("canUndo", editor.session.canUndo())
      .add("canRedo", editor.session.canRedo())
      .add("title", windowTitle(editor.session));
}

void addResult(JsonObject& line, const LevelResult& result) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  line.add("problem", result.problem.value_or(""))
      .add("refined", result.refined)
      .add("complete", result.complete)
      .add("iou", result.match ? result.match->report.silhouetteIou : unknown);
}

void addView(JsonObject& line, const Editor& editor, const UiState& ui) {
  const auto& cell = editor.cell;
  line.add("selection", std::string(nameOf(editor.selection.part)))
      .add("cell", cell ? listOf({double(cell->column), double(cell->row)}) : JsonValue())
      .add("pointPicked", editor.point.has_value())
      .add("viewProblem", ui.viewProblem)
      .add("preparingView", ui.preparingView)
      .add("lookingThrough", editor.lookingThrough)
      .add("pose", poseJson(editor.pose));
}

void addLesson(JsonObject& line, const Editor& editor) {
  line.add("lesson", editor.lesson.lesson.id)
      .add("step", editor.lesson.step)
      .add("stepDone", editor.lesson.done)
      .add("exported", std::size_t(editor.exported));
}

void addPanels(JsonObject& line, const UiState& ui) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  line.add("window", listOf({size.x, size.y}))
      .add("view", rectJson(ui.layout.view))
      .add("properties", rectJson(ui.layout.properties))
      .add("preview", rectJson(ui.layout.preview))
      .add("scale", ui.scale)
      .add("panelsHidden", ui.panelsHidden)
      .add("helpOpen", ui.helpOpen)
      .add("presenting", ui.presenting)
      .add("exporting", ui.exporting.open)
      .add("tourCard", double(ui.tour.card))
      .add("dialog", std::string(openDialog(ui)))
      .add("folder", ui.browser.open ? ui.browser.folder.string() : "")
      .add("typed", ui.browser.text)
      .add("notice", ui.notice ? ui.notice->text : "");
}

void addJobs(JsonObject& line, Gui& gui) {
  const Editor& editor = gui.editor();
  line.add("unfinished", gui.unfinished())
      .add("job", editor.job.busy())
      .add("opening", editor.opening.busy())
      .add("saving", editor.saving.busy())
      .add("message", editor.status.text());
}

}  // namespace

std::string stateLine(Gui& gui, std::size_t frame, const InputCounts& seen, bool resting) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  JsonObject line;
  line.add("frame", frame)
      .add("resting", resting)
      .add("input", countsJson(seen))
      .add("mouse", listOf({mouse.x, mouse.y}));
  addLevel(line, gui.editor());
  addResult(line, gui.editor().updater.result());
  addView(line, gui.editor(), gui.ui());
  addLesson(line, gui.editor());
  addPanels(line, gui.ui());
  addJobs(line, gui);
  return compactJson(line.value());
}

StateLog::StateLog(const std::filesystem::path& path) {
  if (path.empty()) return;
  file_.open(path, std::ios::binary | std::ios::trunc);
  if (!file_) throw Error("cannot be written", path.string());
}

void StateLog::add(Gui& gui, const InputCounts& seen) {
  if (!file_.is_open()) return;
  seen_ = seen;
  file_ << stateLine(gui, ++frames_, seen_) << '\n' << std::flush;
}

void StateLog::addRest(Gui& gui) {
  if (file_.is_open()) file_ << stateLine(gui, frames_, seen_, true) << '\n' << std::flush;
}

}  // namespace anamorph
