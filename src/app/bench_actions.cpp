#include "app/bench_actions.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "edit/replacements.h"
#include "level/level_json.h"
#include "level/limits.h"
#include "panels/actions.h"
#include "pipeline/original.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

bool isComputed(Gui& gui) {
  const LiveUpdater& updater = gui.editor().updater;
  return updater.result().complete && !updater.busy();
}

}  // namespace

fs::path writeKnotLevel(const fs::path& level, std::size_t triangles, const fs::path& folder) {
  constexpr double aspect = 38;  // of segments to sides: the triangles are about as long as wide
  const Level old = loadLevel(level).level;
  const auto placed = placeOriginal(*loadOriginal(old.original.shape, level).mesh, old.original.unitize,
                                    old.original.placement);
  TorusKnotShape knot;
  knot.sides = std::max(3, static_cast<int>(std::lround(std::sqrt(triangles / (2 * aspect)))));
  knot.segments = std::max(3, static_cast<int>(std::lround(triangles / (2.0 * knot.sides))));
  if (!limits::knotSides.level.holds(knot.sides) || !limits::knotSegments.level.holds(knot.segments))
    throw Error(fmt::format("bench-drag: a torus knot of {} triangles cannot be made", triangles));
  const fs::path file = folder / "knot.json";
  saveLevel(file, withOriginal(old, knot, *loadOriginal(knot, {}).mesh, boundingBox(placed->positions)));
  return file;
}

void benchOpen(Gui& gui, FrameRecorder& recorder, const fs::path& level) {
  recorder.begin("open");
  recorder.frame([&] { gui.open(level); });
  recorder.framesWhile([&] { return !isComputed(gui); });
  recorder.begin("settle");
  recorder.rest();
}

void benchView(HeadlessGui& headless, FrameRecorder& recorder, int frames) {
  const Rect& view = headless.gui().ui().layout.view;
  const float x = view.x + 0.5f * view.width, y = view.y + 0.5f * view.height;
  headless.gui().editor().selection = {};  // no handle is in the way
  recorder.begin("orbit");
  headless.moveMouse(x, y);
  recorder.frame();
  headless.pressMouse(2, true);
  for (int i = 1; i <= frames; ++i) {
    headless.moveMouse(x + static_cast<float>(60 * std::sin(2 * pi * i / 80.0)), y);
    recorder.frame();
  }
  headless.pressMouse(2, false);
  recorder.rest();
  recorder.begin("click");
  headless.pressMouse(0, true);
  recorder.frame();
  headless.pressMouse(0, false);
  recorder.rest();
  headless.moveMouse(-1e6f, -1e6f);
}

void benchUndo(Gui& gui, FrameRecorder& recorder) {
  recorder.begin("undo");
  recorder.frame([&] { perform(Action::undo, gui.editor(), gui.ui()); });
  recorder.rest();
}

void benchFiles(Gui& gui, FrameRecorder& recorder, const fs::path& folder) {
  const fs::path own = gui.editor().session.path();
  recorder.begin("switch level");
  for (const fs::path& level : {gui.ui().levels.back().path, own}) {
    recorder.frame([&] { gui.open(level); });
    recorder.rest();
  }
  recorder.begin("save");
  recorder.frame([&] { gui.editor().saving.start(gui.editor().session, folder / "saved.json"); });
  recorder.rest();
  recorder.begin("export");
  recorder.frame([&] {
    gui.ui().exporting.request.path = folder / "sculpture.stl";
    gui.ui().requests.startExport = true;
  });
  recorder.rest();
  recorder.begin("picture of the window");
  recorder.frame([&] { gui.ui().requests.shot = ShotRequest{1, true, false, folder / "window.png"}; });
  recorder.rest();
  recorder.frame([&] { gui.ui().requests.shot = ShotRequest{4, true, false, folder / "large.png"}; });
  constexpr int someFrames = 40;
  for (int i = 0; i < someFrames; ++i) recorder.frame();
  recorder.frame([&] { gui.ui().requests.cancelShot = true; });
  recorder.rest();
}

}  // namespace anamorph
