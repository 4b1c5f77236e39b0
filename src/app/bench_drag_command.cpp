// anamorph bench-drag: how fast does everything follow the mouse? A real drag of the gizmo, of the eye and
// then of the original, through session, pipeline and 3D view, without a display; and the longest frame of all
// that is done.

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "app/bench_actions.h"
#include "app/commands.h"
#include "app/headless_gui.h"
#include "base/error.h"
#include "base/temporary_file.h"
#include "cli/input.h"
#include "cli/print.h"
#include "cli/report.h"
#include "gl/load_gl.h"
#include "panels/view_panel.h"

namespace anamorph {
namespace {

struct BenchOptions {
  std::string level;
  std::size_t triangles = 0;  // of a torus knot as original; 0: the level's own
  int frames = 240;
  std::pair<int, int> size{1280, 800};
};

struct Statistics {
  double median = 0, p95 = 0, max = 0;
};

Statistics statisticsOf(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double fraction) {
    return values[static_cast<std::size_t>(fraction * (values.size() - 1) + 0.5)];
  };
  return {at(0.5), at(0.95), values.back()};
}

// Stages in the order of the data, each with its milliseconds in every frame.
struct Recording {
  std::vector<std::string> stages;
  std::map<std::string, std::vector<double>> values;

  void add(const std::string& stage, double milliseconds) {
    if (values.find(stage) == values.end()) stages.push_back(stage);
    values[stage].push_back(milliseconds);
  }
};

void record(Recording& recording, const Gui& gui, const LiveTimes& live, double gpu) {
  const FrameTimes& t = gui.times();
  recording.add("panels and mouse", t.panels);
  recording.add("original", live.original);
  recording.add("sculpture", live.sculpture);
  recording.add("preview", live.preview);
  recording.add("match", live.match);
  recording.add("rays", live.rays);
  recording.add("lines", t.input);
  recording.add("CPU without OpenGL calls", t.panels + t.advance + t.input);
  recording.add("OpenGL calls, view", t.view);
  recording.add("OpenGL calls, panels", t.draw);
  recording.add("GPU, view", gpu);
}

// Where the arrow of the x axis can be taken, else that of another axis.
Pixel gripOf(Gui& gui) {
  const ShownGizmo shown = currentGizmo(gui.editor(), gui.ui());
  const Rect& view = gui.ui().layout.view;
  constexpr float edge = 6;
  const Rect inner{edge, edge, view.width - 2 * edge, view.height - 2 * edge};
  for (const GizmoHandle handle : {GizmoHandle::x, GizmoHandle::y, GizmoHandle::z}) {
    for (const GizmoShape& shape : shown.gizmo.shapes) {
      if (shape.handle != handle || shape.points.empty()) continue;
      Pixel sum(0);
      for (const Pixel& p : shape.points) sum += p;
      const Pixel middle = sum / double(shape.points.size());
      const bool seen = inner.contains(static_cast<float>(middle.x), static_cast<float>(middle.y));
      if (seen && pickHandle(shown.gizmo, middle) == handle) return middle;
    }
  }
  throw Error("bench-drag: the view shows no handle to drag; change the level's view");
}

Recording drag(HeadlessGui& headless, FrameRecorder& recorder, Part part, int frames) {
  Gui& gui = headless.gui();
  pickPoint(gui.editor(), {});  // the construction of a point hides the handles
  gui.editor().selection = {part, 0};
  recorder.begin(part == Part::eye ? "drag eye" : "drag original");
  recorder.rest();
  const Rect& view = gui.ui().layout.view;
  const Pixel grip = gripOf(gui);
  const auto move = [&](double offset) {
    headless.moveMouse(view.x + static_cast<float>(grip.x + offset), view.y + static_cast<float>(grip.y));
  };
  move(0);
  recorder.frame();
  headless.pressMouse(0, true);
  recorder.frame();
  const Level before = gui.editor().session.level();
  bool moved = false;
  Recording recording;
  for (int i = 1; i <= frames; ++i) {
    move(40 * std::sin(2 * pi * i / 80.0));
    recorder.frame();
    moved |= !(before == gui.editor().session.level());
    record(recording, gui, gui.editor().updater.liveTimes(), gui.times().gpu);
  }
  if (!moved) throw Error("bench-drag: the drag changed nothing");
  headless.pressMouse(0, false);
  recorder.frame();
  headless.moveMouse(-1e6f, -1e6f);
  return recording;
}

void printTable(const std::string& what, const Recording& recording) {
  printLine(stdout, fmt::format("{:<28} {:>9} {:>9} {:>9}", what + ", ms", "median", "p95", "max"));
  for (const std::string& stage : recording.stages) {
    const Statistics s = statisticsOf(recording.values.at(stage));
    printLine(stdout, fmt::format("{:<28} {:>9.2f} {:>9.2f} {:>9.2f}", stage, s.median, s.p95, s.max));
  }
}

JsonValue jsonOf(const Recording& recording) {
  JsonObject object;
  for (const std::string& stage : recording.stages) {
    const Statistics s = statisticsOf(recording.values.at(stage));
    object.add(stage, JsonObject().add("median", s.median).add("p95", s.p95).add("max", s.max).value());
  }
  return object.value();
}

JsonValue jsonOf(const std::vector<ActionFrames>& actions) {
  JsonObject object;
  for (const ActionFrames& a : actions)
    object.add(a.action, JsonObject().add("frames", a.frames).add("longest", a.longest).value());
  return object.value();
}

void printActions(const std::vector<ActionFrames>& actions) {
  printLine(stdout, fmt::format("{:<28} {:>9} {:>9}", "all of a frame, ms", "frames", "longest"));
  for (const ActionFrames& a : actions) {
    printLine(stdout, fmt::format("{:<28} {:>9} {:>9.2f}", a.action, a.frames, a.longest));
  }
}

void bench(const BenchOptions& options, const CommonOptions& common) {
  ScratchFolder folder;
  std::filesystem::path level = levelNamed(options.level);
  if (options.triangles > 0) level = writeKnotLevel(level, options.triangles, folder.path());
  const HeadlessContext context;
  Preferences preferences;
  preferences.uiScale = 1;
  HeadlessGui headless(options.size.first, options.size.second, preferences, common.threads);
  Gui& gui = headless.gui();
  gui.keepShadersWarm({});
  FrameRecorder recorder(headless);
  benchOpen(gui, recorder, level);
  const LevelResult& result = gui.editor().updater.result();
  if (result.problem) throw Error(*result.problem, level.string());
  const std::size_t vertices = result.sculpture.sculpture->mesh.positions.size();
  const std::size_t triangles = result.sculpture.sculpture->mesh.triangles.size();
  benchView(headless, recorder, options.frames);
  const Recording eye = drag(headless, recorder, Part::eye, options.frames);
  benchUndo(gui, recorder);
  const Recording original = drag(headless, recorder, Part::original, options.frames);
  gui.editor().session.undo();
  benchFiles(gui, recorder, folder.path());
  if (common.json) {
    printJson(JsonObject()
                  .add("level", level.string())
                  .add("renderer", rendererName())
                  .add("vertices", vertices)
                  .add("triangles", triangles)
                  .add("frames", static_cast<std::size_t>(options.frames))
                  .add("dragEye", jsonOf(eye))
                  .add("dragOriginal", jsonOf(original))
                  .add("actions", jsonOf(recorder.actions()))
                  .value());
    return;
  }
  printLine(stdout, fmt::format("{}: {} vertices, {} triangles, {} x {} pixels, {}", level.string(), vertices,
                                triangles, options.size.first, options.size.second, rendererName()));
  printTable("drag the eye", eye);
  printTable("drag the original", original);
  printActions(recorder.actions());
}

}  // namespace

void addBenchDragCommand(CLI::App& app, CommonOptions& common) {
  CLI::App* command = app.add_subcommand(
      "bench-drag",
      "Drag eye and original of a level; time every stage, and the longest frame of every action");
  const auto options = std::make_shared<BenchOptions>();
  command->add_option("LEVEL", options->level, "A level (a file, or the name of an installed one)")
      ->required();
  command
      ->add_option("--triangles", options->triangles,
                   "In place of the level's original: a torus knot of about so many triangles")
      ->check(numberIn(limits::triangles));
  command->add_option("--frames", options->frames, "Frames of each drag (default 240)")
      ->check(numberIn(limits::benchFrames));
  addSizeOption(*command, options->size);
  addJsonOption(*command, common);
  addCommonOptions(*command, common);
  command->callback([options, &common] { bench(*options, common); });
}

}  // namespace anamorph
