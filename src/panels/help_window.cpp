// F1: mouse, keys (from the same table that the keyboard uses) and the words of the method.

#include <string>

#include <imgui.h>

#include "base/language.h"
#include "panels/actions.h"
#include "panels/figures.h"
#include "panels/panels.h"
#include "panels/style.h"
#include "panels/view_windows.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

// Already in the chosen language: names of keys are left as they are.
void plainRow(const char* left, const char* right) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(left);
  ImGui::TableNextColumn();
  paragraph(right);
}

void row(const char* left, const char* right) {
  plainRow(tr(left), tr(right));
}

bool beginRows(const UiState& ui, const char* id) {
  if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_RowBg)) return false;
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed, 190 * static_cast<float>(ui.scale));
  return true;
}

void mouseRows(const UiState& ui) {
  if (!section(ui, "Mouse in the 3D view") || !beginRows(ui, "mouse")) return;
  row("Left or middle drag", "Turn around the centre");
  row("Right drag, Shift + middle", "Shift");
  row("Wheel", "Come nearer to what is under the mouse, or go away");
  row("Click",
      "Select; on original and sculpture also show the vertex ray of that point; on the pixel grid isolate a "
      "pixel");
  row("Double click", "Turn around this point from now on");
  row("Drag a handle",
      "Move, turn or scale what is selected. Ctrl: in steps. Shift: finely. X, Y, Z: along one axis. Esc: "
      "undo the drag");
  row("Drag a number", "Change it; double click to type it");
  ImGui::EndTable();
}

// "Ctrl+Y, Ctrl+Shift+Z"; a key of the number pad has its digit's name.
std::string keyNames(const ActionRow& row, bool vrtKeys) {
  std::string names;
  for (const Key& key : keysOf(row, vrtKeys)) {
    const std::string name = keyName(key);
    if (name != names) names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

void keyRows(const UiState& ui) {
  if (!section(ui, "Keys") || !beginRows(ui, "keys")) return;
  for (const ActionRow& row : actionTable()) {
    std::string what = tr(row.name);
    if (*row.help != 0) what += std::string(": ") + tr(row.help);
    plainRow(keyNames(row, ui.preferences.vrtKeys).c_str(), what.c_str());
  }
  ImGui::EndTable();
}

void lineRows(const UiState& ui) {
  if (section(ui, "Lines")) drawAllLegendLines(ui);
}

void wordRows(const UiState& ui) {
  if (!section(ui, "Words")) return;
  drawFigure("construction", ui);
  if (!beginRows(ui, "words")) return;
  row("eye E", "The viewer's point, where the RT camera is");
  row("original, P", "The object that is to be seen, and a vertex of it");
  row("mirror, Q, N", "Where the ray from E to P meets the mirror, and the normal there");
  row("sculpture, S",
      "The deformed object, and the vertex made for P: from Q along the reflected ray, k times as far as P "
      "is behind Q");
  row("depth scale k",
      "How far out the sculpture reaches; seen from the eye it changes nothing, as long as nothing hides "
      "anything");
  row("match", "How well the reflection agrees with the original seen directly");
  ImGui::EndTable();
}

}  // namespace

void drawHelpWindow(Editor&, UiState& ui) {
  if (!ui.helpOpen) return;
  if (beginToolWindow(ui, "Help", "###help", ui.helpOpen, 640, 620, 0.9f)) {
    mouseRows(ui);
    keyRows(ui);
    lineRows(ui);
    wordRows(ui);
  }
  ImGui::End();
}

}  // namespace anamorph
