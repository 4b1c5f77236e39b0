// The status line: what happened last, what is being computed, how large and how fast everything is.

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

std::string stateText(const LevelResult& result) {
  const Sculpture* sculpture = result.sculpture.sculpture.get();
  const bool isThere =
      sculpture && !sculpture->mesh.triangles.empty();  // a frozen one is, whatever the problem
  if (result.problem) return tr(isThere ? "nothing to compare" : "no sculpture");
  if (!sculpture) return tr("loading");
  if (!result.refined) return tr("following, not refined");
  return tr(result.complete ? "refined and matched" : "refined, matching");
}

std::string figures(const UiState& ui, const LevelResult& result) {
  std::string text;
  if (result.sculpture.sculpture) {
    const Mesh& mesh = result.sculpture.sculpture->mesh;
    text = trFormat("{} vertices  {} triangles", mesh.positions.size(), mesh.triangles.size());
  }
  if (!ui.headless) text += fmt::format("   {:.0f} ms", ui.frameMilliseconds);
  return text;
}

void progress(Editor& editor, const UiState& ui) {
  const float s = static_cast<float>(ui.scale);
  ImGui::SameLine();
  ImGui::ProgressBar(static_cast<float>(editor.updater.fraction()), {110 * s, ImGui::GetTextLineHeight()},
                     "");
  ImGui::SameLine();
  if (ImGui::SmallButton(tr("Cancel"))) editor.updater.cancel();
}

// A level that is being read.
void openingProgress(Editor& editor, const UiState& ui) {
  ImGui::SameLine(0, 24 * static_cast<float>(ui.scale));
  const std::string file = editor.opening.path().filename().string();
  ImGui::TextUnformatted(trFormat("Reading {}", file).c_str());
  ImGui::SameLine();
  ImGui::PushID("opening");
  if (ImGui::SmallButton(tr("Cancel"))) editor.opening.cancel();
  ImGui::PopID();
}

// Of something else that is being made. Returns whether it is to be cancelled.
bool jobProgress(const char* name, double fraction, const UiState& ui) {
  const float s = static_cast<float>(ui.scale);
  ImGui::SameLine(0, 24 * s);
  ImGui::TextUnformatted(name);
  ImGui::SameLine();
  ImGui::ProgressBar(static_cast<float>(fraction), {110 * s, ImGui::GetTextLineHeight()}, "");
  ImGui::SameLine();
  ImGui::PushID(name);
  const bool cancel = ImGui::SmallButton(tr("Cancel"));
  ImGui::PopID();
  return cancel;
}

}  // namespace

void drawStatusLine(Editor& editor, UiState& ui) {
  const Rect& rect = ui.layout.status;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      {ImGui::GetStyle().WindowPadding.x, 4 * static_cast<float>(ui.scale)});
  const bool shown = beginPanel("status", rect, true, false);
  ImGui::PopStyleVar();
  if (!shown) return;
  const LevelResult& result = editor.updater.result();
  const std::string state = stateText(result);
  ImGui::TextUnformatted(state.c_str());
  if (editor.updater.busy() && !result.complete && !ui.headless) progress(editor, ui);
  if (editor.job.busy() && jobProgress(editor.job.name().c_str(), editor.job.fraction(), ui))
    editor.job.cancel();
  if (editor.opening.busy()) openingProgress(editor, ui);
  if (ui.shot.running && jobProgress(tr("The picture is being drawn..."), ui.shot.fraction, ui))
    ui.requests.cancelShot = true;
  const std::string message = !editor.message.empty()         ? editor.message
                              : !result.warnings.empty()      ? result.warnings.front()
                              : !result.shapeWarnings.empty() ? result.shapeWarnings.front()
                              : result.match && result.refined
                                  ? findMatchProblem(result.match->report).value_or("")
                                  : std::string();
  const std::string right = figures(ui, result);
  const float rightWidth = ImGui::CalcTextSize(right.c_str()).x;
  const float rightX = ImGui::GetWindowWidth() - rightWidth - ImGui::GetStyle().WindowPadding.x;
  if (!message.empty()) {
    ImGui::SameLine(0, 24 * static_cast<float>(ui.scale));
    const ImVec2 p = ImGui::GetCursorScreenPos();
    const ImVec4 color =
        editor.message.empty() ? ink::middling(ui.theme) : ImGui::GetStyleColorVec4(ImGuiCol_Text);
    const float end = rect.x + rightX - 12 * static_cast<float>(ui.scale);
    ImGui::PushClipRect(p, {end, rect.y + rect.height}, true);
    ImGui::TextColored(color, "%s", message.c_str());
    ImGui::PopClipRect();
    tooltip(message.c_str());
  }
  if (rightX > 0.4f * rect.width) {
    ImGui::SameLine(rightX);
    ImGui::PushStyleColor(ImGuiCol_Text, ink::quiet(ui.theme));
    ImGui::TextUnformatted(right.c_str());
    ImGui::PopStyleColor();
  }
  ImGui::End();
}

}  // namespace anamorph
