#include "panels/view_windows.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <variant>

#include <imgui.h>
#include <imgui_internal.h>

#include "base/language.h"
#include "edit/level_repairs.h"
#include "optics/shape_table.h"
#include "panels/file_flow.h"
#include "panels/help_buttons.h"
#include "panels/highlight.h"
#include "panels/level_sharing.h"
#include "panels/style.h"
#include "panels/widgets.h"
#include "raytrace/ray_looks.h"

namespace anamorph {
namespace {

constexpr int floating = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                         ImGuiWindowFlags_NoBringToFrontOnFocus;

float scaled(const UiState& ui, float length) {
  return length * static_cast<float>(ui.scale);
}

// At most so wide, and no wider than leaves something of the view.
float wrapAt(const UiState& ui, float width) {
  return std::min(scaled(ui, width), std::max(scaled(ui, 160), ui.layout.view.width - scaled(ui, 60)));
}

// The window that has just begun goes in front of the view and behind everything else: Dear ImGui has no flag for
// that, only a list of windows from back to front.
void placeAboveView() {
  ImGuiContext& g = *GImGui;
  ImGuiWindow* const view = ImGui::FindWindowByName("view");
  ImGuiWindow* window = g.CurrentWindow;
  if (!view || !window->Appearing) return;
  g.Windows.find_erase(window);
  g.Windows.insert(g.Windows.find(view) + 1, window);
}

// At a corner or edge of the view; (0, 0) is its upper left, (1, 1) its lower right corner.
void beginFloating(const UiState& ui, const char* name, ImVec2 corner, float alpha, float rounding) {
  const Rect& view = ui.layout.view;
  const float gap = scaled(ui, 10);
  ImGui::SetNextWindowPos(
      {view.x + gap + corner.x * (view.width - 2 * gap), view.y + gap + corner.y * (view.height - 2 * gap)},
      ImGuiCond_Always, corner);
  ImGui::SetNextWindowBgAlpha(alpha);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, scaled(ui, rounding));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {scaled(ui, 8), scaled(ui, 6)});
  ImGui::Begin(name, nullptr, floating);
  placeAboveView();
  ImGui::PopStyleVar(2);
}

// The faults that there is a way out of.
void sceneRepairs(Editor& editor, UiState& ui) {
  const Level& level = editor.session.level();
  const Box box = originalBox(editor);
  const Repairs& repairs = ui.repairs.at(level, box);
  if (!(repairs.eyeOutside == level)) {
    if (ImGui::Button(tr("Move the eye outside the mirror"))) editor.session.edit(repairs.eyeOutside);
    ImGui::SameLine();
  } else if (!findProblem(level.optic)) {
    if (level.sculpture.frozen) {
      if (ImGui::Button(tr("Let it follow again"))) toggleFrozen(editor);
      ImGui::SameLine();
    } else if (!repairs.isBehind || !box.empty()) {
      if (ImGui::Button(tr(repairs.isBehind ? "Fit to the mirror" : "Put the original behind the mirror")))
        repairs.isBehind ? startFit(editor) : startBehind(editor);
      ImGui::SameLine();
    }
  }
}

void repairButtons(Editor& editor, UiState& ui) {
  const bool isRead = editor.updater.result().shape != nullptr;
  if (isRead) sceneRepairs(editor, ui);
  const Shape& mirror = editor.session.level().optic.shape();
  if (shapeTypes()[shapeIndex(mirror)].needsFile && findShapeProblem(mirror)) {
    if (ImGui::Button(tr("Look for the mirror's mesh..."))) chooseMirror(editor, ui);
    ImGui::SameLine();
  }
  if (!isRead && std::holds_alternative<FileShape>(editor.session.level().original.shape)) {
    if (ImGui::Button(tr("Look for the mesh..."))) askForMesh(editor, ui);
    ImGui::SameLine();
  }
  if (editor.session.canUndo()) {
    if (ImGui::Button(tr("Undo"))) editor.session.undo();
    ImGui::SameLine();
  }
  if (ImGui::Button(tr("Reset the level"))) editor.session.reset();
}

void legendLine(const UiState& ui, const LineLook& look) {
  const ImU32 color = ink::of(look.color);
  const float width = scaled(ui, 34), height = ImGui::GetTextLineHeight();
  const ImVec2 p = ImGui::GetCursorScreenPos();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float y = p.y + height / 2, thick = scaled(ui, 2.4f);
  if (look.style == LineStyle::solid) {
    list->AddLine({p.x, y}, {p.x + width, y}, color, thick);
  } else {
    const bool dashed = look.style == LineStyle::dashed;
    const float on = scaled(ui, dashed ? 8.0f : 2.5f), off = scaled(ui, dashed ? 5.0f : 4.0f);
    for (float x = 0; x < width; x += on + off) {
      list->AddLine({p.x + x, y}, {p.x + std::min(x + on, width), y}, color, thick);
    }
  }
  ImGui::Dummy({width, height});
  ImGui::SameLine();
  ImGui::TextUnformatted(tr(look.legend));
}

// The caustic's dots.
void legendDot(const UiState& ui, const Rgb& color, const char* name) {
  const float height = ImGui::GetTextLineHeight(), width = scaled(ui, 34);
  const ImVec2 p = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddCircleFilled({p.x + width / 2, p.y + height / 2}, scaled(ui, 3),
                                              ink::of(color));
  ImGui::Dummy({width, height});
  ImGui::SameLine();
  ImGui::TextUnformatted(tr(name));
}

void legendCaustic(const UiState& ui) {
  legendDot(ui, palette::firstCaustic, "where the rays cross first");
  legendDot(ui, palette::secondCaustic, "where they cross again");
}

void legendRays(const Editor& editor, const UiState& ui) {
  const auto add = [&](RayKind kind) { legendLine(ui, lookOf(kind).line); };
  // The vertex rays of a frozen sculpture begin at the point that it was made for.
  LineLook camera = lookOf(RayKind::camera).line;
  if (editor.session.level().sculpture.frozen && editor.rays.source == RaySource::vertices)
    camera.legend = "from where the eye was";
  legendLine(ui, camera);
  const bool reflects = isVisible(editor.session.level().optic);
  if (reflects) add(RayKind::reflected);
  if (editor.point && reflects) legendLine(ui, normalLook);
  if (editor.rays.lightRays) {
    add(RayKind::light);
    add(RayKind::shadow);
  }
  if (!editor.rays.hideNoHit) add(RayKind::noHit);
}

}  // namespace

void drawViewButtons(Editor& editor, UiState& ui) {
  if (ui.layout.view.width < scaled(ui, 220) || ui.layout.view.height < scaled(ui, 120)) return;
  beginFloating(ui, "##view-buttons", {1, 1}, 0, 6);
  if (ImGui::Button(tr(editor.lookingThrough ? "Back to where I was" : "Look through the RT camera")))
    toggleLookThrough(editor);
  highlightItem("Look through the RT camera");
  tooltip("The key 0 does the same.");
  ImGui::End();
}

void drawProblem(Editor& editor, UiState& ui) {
  const auto& problem = editor.updater.result().problem;
  if (!problem) return;
  beginFloating(ui, "##problem", {0.5f, 0.16f}, 0.94f, 8);
  {
    const FontScope strong(ui.fonts.strong);
    const bool isThere = !sculptureBox(editor).empty();  // a frozen one
    ImGui::TextColored(ink::bad(ui.theme), "%s",
                       tr(isThere ? "There is nothing to compare" : "There is no sculpture"));
  }
  paragraph(capitalised(*problem), wrapAt(ui, 460));
  repairButtons(editor, ui);
  ImGui::End();
}

void drawViewSigns(Editor& editor, UiState& ui) {
  struct Sign {
    bool shown;
    const char *text, *button;
    void (*undo)(Editor&);
  };
  const DisplaySettings& display = editor.display;
  const bool alone = display.alone != ShownAlone::nothing;
  const Sign signs[] = {
      {editor.session.level().sculpture.frozen.has_value(), "Sculpture frozen", "Let it follow again",
       toggleFrozen},
      {alone, "Only one thing is shown", "Show everything",
       [](Editor& e) { e.display.alone = ShownAlone::nothing; }},
      {!alone && !display.mirror, "The mirror is hidden", "Show the mirror",
       [](Editor& e) { e.display.mirror = true; }},
  };
  const auto isShown = [](const Sign& sign) { return sign.shown; };
  if (std::none_of(std::begin(signs), std::end(signs), isShown)) return;
  const bool narrow = ui.layout.view.width < scaled(ui, 520);  // the legend is beside it
  beginFloating(ui, "##signs", {0, 0}, 0.94f, 6);
  for (const Sign& sign : signs) {
    if (!sign.shown) continue;
    if (!narrow) ImGui::AlignTextToFramePadding();
    {
      const FontScope strong(ui.fonts.strong);
      ImGui::TextUnformatted(tr(sign.text));
    }
    if (!narrow) ImGui::SameLine();
    if (ImGui::Button(label(sign.button).c_str())) sign.undo(editor);
    highlightItem(sign.button);
  }
  ImGui::End();
}

void drawViewProblem(const UiState& ui) {
  if (ui.viewProblem.empty() && !ui.preparingView) return;
  beginFloating(ui, "##view-problem", {0, 0.16f}, 0.94f, 6);
  ImGui::PushStyleColor(ImGuiCol_Text, ink::middling(ui.theme));
  if (ui.preparingView) paragraph(tr("The 3D view is being prepared for this machine..."), wrapAt(ui, 320));
  if (!ui.viewProblem.empty()) paragraph(capitalised(ui.viewProblem), wrapAt(ui, 320));
  ImGui::PopStyleColor();
  ImGui::End();
}

void drawLongMessage(Editor& editor, const UiState& ui) {
  beginFloating(ui, "##long-message", {0, 1}, 0.94f, 6);
  paragraph(capitalised(editor.status.text()), wrapAt(ui, 480));
  if (ImGui::Button(tr("OK"))) editor.status.clear();
  ImGui::End();
}

void drawPausedRays(const Editor& editor, const UiState& ui) {
  if (!editor.rays.show || !editor.rays.animate || !editor.animationPaused) return;
  beginFloating(ui, "##paused", {0.5f, 0}, 0.72f, 6);
  ImGui::TextUnformatted(tr("Rays paused - Space"));
  ImGui::End();
}

void drawLegend(const Editor& editor, const UiState& ui) {
  if (!editor.rays.show && !editor.display.caustic) return;
  if (ui.layout.view.width < scaled(ui, 420) || ui.layout.view.height < scaled(ui, 300)) return;
  beginFloating(ui, "##legend", {1, 0}, 0.72f, 6);
  if (editor.rays.show) legendRays(editor, ui);
  if (editor.display.caustic) legendCaustic(ui);
  ImGui::End();
}

void drawAllLegendLines(const UiState& ui) {
  for (const RayLook& look : rayLooks) {
    legendLine(ui, look.line);
    if (look.kind == RayKind::reflected)
      legendLine(ui, normalLook);  // in the order of a vertex's construction
  }
  legendCaustic(ui);
}

}  // namespace anamorph
