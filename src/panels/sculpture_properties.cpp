// The sculpture: how far it reaches, how fine it is, how it came about; and the construction of a picked
// vertex.

#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "base/count.h"
#include "base/language.h"
#include "panels/highlight.h"
#include "panels/material_rows.h"
#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

void frozenRows(Editor& editor, const UiState& ui) {
  const auto frozen = frozenSentence(editor.session.level());
  if (frozen) quietText(ui, (capitalised(*frozen) + ".").c_str());
  const bool pressed =
      wideButton(frozen ? "Let it follow again" : "Freeze the sculpture",
                 frozen ? "It is made for the eye as it is now."
                        : "It stays as it is. Move the eye, the original or the mirror then: the match tells "
                          "what it is still worth.",
                 canToggleFrozen(editor));
  if (frozen) highlightItem("Freeze the sculpture");  // the same control, which "Do it" has pressed at once
  if (pressed) toggleFrozen(editor);
}

// Of a frozen sculpture only the fineness can be changed.
bool deformationRows(SculptureSettings& sculpture) {
  const bool frozen = sculpture.frozen.has_value();
  double& depthScale = frozen ? sculpture.frozen->depthScale : sculpture.depthScale;
  ImGui::BeginDisabled(frozen);
  bool changed = sliderRow("Depth scale k", depthScale, {limits::depthScale.panel, 0.01, "%.2f"},
                           "S lies k times as far from the mirror as P does. Seen from the eye that changes "
                           "nothing, as long as nothing hides anything.",
                           true);
  double& depthOffset = frozen ? sculpture.frozen->depthOffset : sculpture.depthOffset;
  const bool moved =
      sliderRow("Depth offset", depthOffset, {limits::depthOffset.panel, 0.02, "%.2f"},
                "So much farther from the mirror, along the reflected rays: beyond the place where the "
                "rays of a hollow mirror cross.");
  ImGui::EndDisabled();
  // The one value that is a case of its own is met by a drag; what is typed stays as it was typed.
  if (changed && ImGui::IsMouseDown(0) && std::abs(std::log(depthScale)) < 0.04) depthScale = 1;
  changed |= moved;
  bool refine = sculpture.tolerancePixels > 0;
  if (checkRow("Refine", refine,
               "Split the triangles until their edges are straight in the mirror. Off: the original's own "
               "vertices, as in the thesis.")) {
    sculpture.tolerancePixels = refine ? SculptureSettings{}.tolerancePixels : 0;
    changed = true;
  }
  if (refine) {
    changed |= sliderRow("Tolerance", sculpture.tolerancePixels, {limits::tolerance.panel, 0.01, "%.2f px"},
                         "How far an edge may be off its curve, in pixels of a 512 pixel image.", true);
  }
  return changed;
}

// Each is right when its box is ticked. Folded where a level has no mistakes to find.
bool formulaRows(const UiState& ui, const Editor& editor, Mistakes& mistakes) {
  ImGui::PushID(editor.session.generation());
  const bool open =
      section(ui, "Formulas", mistakes.any() || editor.session.saved().sculpture.mistakes.any());
  ImGui::PopID();
  if (!open) return false;
  const auto row = [](const char* name, bool& mistake, const char* help) {
    bool right = !mistake;
    if (!checkRow(name, right, help)) return false;
    mistake = !right;
    return true;
  };
  bool changed =
      row("Direction is right", mistakes.direction,
          "Ticked: the ray from the eye is reflected. Not ticked: the ray towards the eye is, as in the "
          "thesis' published program, and everything lands behind the mirror.");
  changed |= row(
      "Normal is right", mistakes.normal,
      "Ticked: a cylinder's normal points away from its axis. Not ticked: from its middle, as if it were a "
      "sphere.");
  changed |= row("Distance is right", mistakes.distance,
                 "Ticked: d = |PQ|. Not ticked: |(P − E) − Q|, which takes a point from a direction.");
  return changed;
}

void resultRows(const Editor& editor) {
  const LevelResult& result = editor.updater.result();
  if (!result.sculpture.sculpture) return;
  const Mesh& mesh = result.sculpture.sculpture->mesh;
  const Box box = boundingBox(mesh.positions);
  if (!box.empty()) {
    const Vector size = box.size();
    textRow("Size", shownFormat("{:.2f} x {:.2f} x {:.2f}", size.x, size.y, size.z),
            "Of its box, scene units.");
  }
  textRow("Mesh", countOf(mesh.positions.size(), "vertex", "vertices") + ", " +
                      countOf(mesh.triangles.size(), "triangle", "triangles"));
  textRow("Vertices", shownStatus(result.sculpture.sculpture->originalStatus),
          "What became of the original's own vertices.");
}

void constructionRows(Editor& editor, const UiState& ui) {
  const auto& construction = currentConstruction(editor);
  if (!construction) {
    quietText(
        ui,
        "Click a point of the original or of the sculpture: its vertex ray is drawn, with all its numbers.");
    return;
  }
  for (const auto& [name, value] : construction->rows) textRow(name.c_str(), value);
  if (!construction->explanation.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, ink::bad(ui.theme));
    paragraph(construction->explanation);
    ImGui::PopStyleColor();
  }
  if (wideButton("Let it go", "Esc does the same.")) pickPoint(editor, {});
}

}  // namespace

void drawSculptureProperties(Editor& editor, UiState& ui) {
  Level level = editor.session.level();
  bool changed = false;
  if (section(ui, "Deformation")) {
    changed |= deformationRows(level.sculpture);
    frozenRows(editor, ui);
  }
  auto& frozen = level.sculpture.frozen;
  ImGui::BeginDisabled(frozen.has_value());
  changed |= formulaRows(ui, editor, frozen ? frozen->mistakes : level.sculpture.mistakes);
  ImGui::EndDisabled();
  if (section(ui, "Result")) resultRows(editor);
  if (section(ui, "Vertex ray")) constructionRows(editor, ui);
  if (section(ui, "Shown as")) {
    sliderRow(
        "Morph", editor.display.morph, {limits::fractions, 0.01, "%.2f"},
        "0 is the original, 1 the sculpture; in between every vertex is on its way along its vertex ray.");
    checkRow("Sculpture", editor.display.sculpture);
    checkRow("Triangle edges", editor.display.wireframe, "How fine the sculpture is.");
    checkRow("Colour by status", editor.display.statusColors,
             "Which vertices are mapped, and why others are not.");
  }
  if (section(ui, "Material", false)) changed |= materialRows(level.sculpture.material);
  if (changed) editor.session.change(std::move(level));
}

}  // namespace anamorph
