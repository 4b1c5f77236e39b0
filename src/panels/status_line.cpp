// The status line: what happened last, what is being computed, how large and how fast everything is.

#include <algorithm>
#include <string>

#include <imgui.h>

#include "base/count.h"
#include "base/language.h"
#include "panels/panels.h"
#include "panels/state_words.h"
#include "panels/style.h"
#include "panels/view_windows.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

std::string figures(const UiState& ui, const LevelResult& result) {
  std::string text;
  if (result.sculpture.sculpture) {
    const Mesh& mesh = result.sculpture.sculpture->mesh;
    text = countOf(mesh.positions.size(), "vertex", "vertices") + "  " +
           countOf(mesh.triangles.size(), "triangle", "triangles");
  }
  if (!ui.headless) text += shownFormat("   {:.0f} ms", ui.frameMilliseconds);
  return text;
}

// Dear ImGui's own bar would push the words beside it down by its padding.
void bar(double fraction, const UiState& ui) {
  const ImVec2 low = ImGui::GetCursorScreenPos(),
               size{110 * static_cast<float>(ui.scale), ImGui::GetTextLineHeight()};
  const float filled = size.x * static_cast<float>(std::clamp(fraction, 0.0, 1.0));
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(low, {low.x + size.x, low.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg));
  list->AddRectFilled(low, {low.x + filled, low.y + size.y}, ImGui::GetColorU32(ImGuiCol_PlotHistogram));
  ImGui::Dummy(size);
}

void progress(Editor& editor, const UiState& ui) {
  ImGui::SameLine();
  bar(editor.updater.fraction(), ui);
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

// A level that is being written: nothing cancels that.
void savingProgress(const Editor& editor, const UiState& ui) {
  ImGui::SameLine(0, 24 * static_cast<float>(ui.scale));
  ImGui::TextUnformatted(trFormat("Writing {}", editor.saving.path().filename().string()).c_str());
}

// Of something else that is being made. Returns whether it is to be cancelled.
bool jobProgress(const char* name, double fraction, const UiState& ui) {
  ImGui::SameLine(0, 24 * static_cast<float>(ui.scale));
  ImGui::TextUnformatted(name);
  ImGui::SameLine();
  bar(fraction, ui);
  ImGui::SameLine();
  ImGui::PushID(name);
  const bool cancel = ImGui::SmallButton(tr("Cancel"));
  ImGui::PopID();
  return cancel;
}

// What was said last, else what is to be known of the sculpture.
std::string messageOf(const Editor& editor) {
  const LevelResult& result = editor.updater.result();
  if (!editor.status.text().empty()) return editor.status.text();
  if (!result.warnings.empty()) return result.warnings.front();
  if (!result.shapeWarnings.empty()) return result.shapeWarnings.front();
  if (result.match && result.refined) return findMatchProblem(result.match->report).value_or("");
  return {};
}

// As much of it as has room, and a sign that there is more.
std::string elided(const std::string& text, float room) {
  if (ImGui::CalcTextSize(text.c_str()).x <= room) return text;
  const char* const more = "\u2026";
  const char *begin = text.data(), *end = begin + text.size(), *rest = begin;
  ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), room - ImGui::CalcTextSize(more).x, 0, begin, end,
                                  &rest);
  return std::string(begin, rest) + more;
}

// `right`: to where there is room, in the window. What is said and has no room there stands above it, until it has been
// read: the end of a long message is what to do.
void drawMessage(Editor& editor, const UiState& ui, const std::string& message, float right) {
  const bool isSaid = !editor.status.text().empty();
  if (isSaid && ImGui::CalcTextSize(message.c_str()).x > right - ImGui::GetCursorPosX())
    return drawLongMessage(editor, ui);
  const ImVec4 color = isSaid ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : ink::middling(ui.theme);
  ImGui::TextColored(color, "%s", elided(message, right - ImGui::GetCursorPosX()).c_str());
  tooltip(capitalised(message).c_str());
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
  const bool busy = editor.updater.busy();
  ImGui::TextUnformatted(tr(stateWords(result, busy)));
  if (busy && !result.complete && !ui.headless) progress(editor, ui);
  if (editor.job.busy() && jobProgress(editor.job.name().c_str(), editor.job.fraction(), ui))
    editor.job.cancel();
  if (editor.opening.busy()) openingProgress(editor, ui);
  if (editor.saving.busy()) savingProgress(editor, ui);
  if (ui.shot.running && jobProgress(tr("The picture is being drawn..."), ui.shot.fraction, ui))
    ui.requests.cancelShot = true;
  const float s = static_cast<float>(ui.scale);
  const float edge = ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x;
  const std::string right = figures(ui, result), message = messageOf(editor);
  const float rightX = edge - ImGui::CalcTextSize(right.c_str()).x;
  bool figuresShown = rightX > 0.4f * rect.width;
  if (!message.empty()) {
    ImGui::SameLine(0, 24 * s);
    const float end = ImGui::GetCursorPosX() + ImGui::CalcTextSize(message.c_str()).x;
    figuresShown &= end <= rightX - 12 * s;  // words are worth more
    drawMessage(editor, ui, message, figuresShown ? rightX : edge);
  }
  if (figuresShown) {
    ImGui::SameLine(rightX);
    ImGui::PushStyleColor(ImGuiCol_Text, ink::quiet(ui.theme));
    ImGui::TextUnformatted(right.c_str());
    ImGui::PopStyleColor();
  }
  ImGui::End();
}

}  // namespace anamorph
