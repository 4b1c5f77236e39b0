// The original: what it is, where it stands, how it looks.

#include <algorithm>
#include <array>
#include <filesystem>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "base/language.h"
#include "edit/model_turns.h"
#include "edit/replacements.h"
#include "level/freeze.h"
#include "panels/file_flow.h"
#include "panels/help_buttons.h"
#include "panels/material_rows.h"
#include "panels/panels.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

struct ShapeRows {
  bool operator()(BoxShape& box) const {
    bool changed = vectorRow("Size", box.size, {limits::shapeSize.panel, 0.01, "%.2f"});
    changed |= integerRow("Segments", box.segments, limits::boxSegments.panel,
                          "Quads along every edge. 1 gives 8 vertices: try it with the tolerance off.");
    return changed;
  }
  bool operator()(SphereShape& sphere) const {
    bool changed = numberRow("Radius", sphere.radius, {limits::shapeSize.panel, 0.01, "%.2f"});
    changed |= integerRow("Segments", sphere.segments, limits::sphereSegments.panel, "Around its equator.");
    return changed;
  }
  bool operator()(TorusKnotShape& knot) const {
    bool changed = numberRow("Tube radius", knot.tubeRadius, {limits::tubeRadius, 0.005, "%.2f"});
    changed |= integerRow("Segments", knot.segments, limits::knotSegments.panel, "Along the knot.");
    changed |= integerRow("Sides", knot.sides, limits::knotSides.panel, "Around the tube.");
    return changed;
  }
  bool operator()(LetterFShape& letter) const {
    bool changed = numberRow("Height", letter.height, {limits::shapeSize.panel, 0.01, "%.2f"});
    changed |= integerRow("Segments", letter.segments, limits::letterSegments.panel,
                          "Along every edge of its blocks.");
    return changed;
  }
  bool operator()(PawnShape& pawn) const {
    bool changed = numberRow("Height", pawn.height, {limits::shapeSize.panel, 0.01, "%.2f"});
    changed |= integerRow("Segments", pawn.segments, limits::pawnSegments.panel, "Around its axis.");
    return changed;
  }
  bool operator()(FileShape& file) const {
    const std::string name = std::filesystem::path(file.path).filename().string();
    textRow(file.obj->empty() ? "File" : "Inside the level", name, file.path.c_str());
    return false;
  }
};

// Another built-in shape fits the old one's box; a mesh comes from the file browser.
bool shapeRows(Editor& editor, UiState& ui, Level& level) {
  OriginalShape& shape = level.original.shape;
  std::vector<const char*> names{"Box", "Sphere", "Torus knot", "Letter F", "Pawn"};
  const bool isFile = std::holds_alternative<FileShape>(shape);
  if (isFile) names.push_back("Mesh file");
  int kind = static_cast<int>(shape.index());
  if (choiceRow("Shape", kind, names, "What is to be seen in the mirror.") &&
      kind != static_cast<int>(shape.index())) {
    level = withBuiltInOriginal(level, static_cast<std::size_t>(kind), originalBox(editor));
    return true;
  }
  const bool changed = std::visit(ShapeRows{}, shape);
  const LevelResult& result = editor.updater.result();
  if (!result.original.mesh && result.problem) problemText(ui, *result.problem);  // it cannot be read
  if (wideButton(
          isFile ? "Another mesh..." : "A mesh from a file...",
          "OBJ, STL or PLY, fitted to where the original is now. It can be dropped on the window, too.")) {
    chooseOriginal(editor, ui);
  }
  return changed;
}

// How many of its vertices are not mapped, most frequent reason first.
std::string missedText(const LevelResult& result) {
  if (!result.sculpture.sculpture) return "";
  const StatusCounts& counts = result.sculpture.sculpture->originalStatus;
  const std::size_t all = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  const auto worst = std::max_element(counts.begin() + 1, counts.end());
  if (*worst == 0) return "";
  constexpr std::array texts{
      "", "{} of {} vertices miss the mirror", "{} of {} vertices are in front of the mirror",
      "{} of {} vertex rays only graze the mirror", "{} of {} vertex rays meet the mirror a second time"};
  return trFormat(fmt::runtime(texts.at(static_cast<std::size_t>(worst - counts.begin()))), *worst, all);
}

bool placementRows(Placement& placement) {
  bool changed = vectorRow("Position", placement.position, {limits::coordinates, 0.02, "%.2f"},
                           "Of the shape's own origin.");
  changed |= vectorRow("Rotation", placement.rotationDegrees, {limits::coordinates, 0.5, "%.1f°"},
                       "About x, then y, then z.");
  changed |= vectorRow("Scale", placement.scale, {limits::shapeScale.panel, 0.005, "%.3f"},
                       "Along the shape's own axes.");
  return changed;
}

// For what lies on its back, or looks away.
bool turnRows(const Editor& editor, Level& level) {
  const auto placed = editor.updater.result().original.mesh;
  const Level before = level;
  const auto* file = std::get_if<FileShape>(&level.original.shape);
  if (file && wideButton("Stand up",
                         "Most models that were not made for printing have y up. Their y axis becomes the "
                         "height here; again: -y, x and z.",
                         placed && !level.sculpture.frozen)) {
    level = withModelUp(level, nextModelUp(file->up), *placed);
  }
  int axis = -1;
  if (segmentedControl("turns", axis, {"Turn x 90°", "Turn y 90°", "Turn z 90°"}, 3) && placed)
    level = turnedQuarter(level, axis, *placed);
  return !(level == before);
}

}  // namespace

void drawOriginalProperties(Editor& editor, UiState& ui) {
  Level level = editor.session.level();
  bool changed = false;
  if (section(ui, "Original") && shapeRows(editor, ui, level)) {
    level = following(level);  // what is frozen was made from the shape as it was
    changed = true;
  }
  if (section(ui, "Placement")) {
    changed |= placementRows(level.original.placement);
    changed |= turnRows(editor, level);
    problemText(ui, missedText(editor.updater.result()));
    originalButtons(editor);
  }
  if (section(ui, "Shown as")) {
    int look = static_cast<int>(editor.display.originalLook);
    if (choiceRow("Original", look, {"Solid", "Ghost", "Hidden"},
                  "In the 3D view. A ghost shines through the mirror in front of it.")) {
      editor.display.originalLook = static_cast<OriginalLook>(look);
    }
    checkRow("Seen in the mirror", editor.display.originalInMirror,
             "Whether the mirror of the 3D view reflects the original too.");
  }
  if (section(ui, "Material", false)) changed |= materialRows(level.original.material);
  if (changed) editor.session.change(std::move(level));
}

}  // namespace anamorph
