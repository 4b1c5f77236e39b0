// Points and badges: what the student has done in all lessons, and a way to begin anew.

#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "edit/lesson_run.h"
#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

void lessonRow(const LevelEntry& entry, const Editor& editor, const UiState& ui) {
  const LessonScore score = scoreOf(entry.lesson, editor.progress);
  const float size = ImGui::GetFontSize();
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const ImVec2 p = ImGui::GetCursorScreenPos();
  if (score.badge) drawStar({p.x + size / 2, p.y + size / 2}, size / 2);
  ImGui::Dummy({size, size});
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(tr(entry.title.c_str()));
  if (score.badge) {
    quietText(ui, fmt::format("{}: {}", tr(entry.lesson.badge.title), tr(entry.lesson.badge.text)).c_str());
  }
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(fmt::format(fmt::runtime(tr("{} of {} steps")), score.done, score.steps).c_str());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(fmt::format(fmt::runtime(tr("{} of {} points")), score.points, score.of).c_str());
}

// Asked twice, because it cannot be undone.
void resetButton(Editor& editor, UiState& ui) {
  const bool any = !editor.progress.empty();
  if (!any) ui.resetAsked = false;
  if (!ui.resetAsked) {
    if (wideButton("Reset progress", "Forget all steps that were done.", any)) ui.resetAsked = true;
    return;
  }
  quietText(ui, "All points and badges will be gone.");
  if (wideButton("Yes, forget them")) {
    editor.progress.clear();
    openStep(editor, 0);
    ui.resetAsked = false;
  }
  if (wideButton("Keep them")) ui.resetAsked = false;
}

}  // namespace

void drawProgressWindow(Editor& editor, UiState& ui) {
  if (!ui.progressOpen) {
    ui.resetAsked = false;
    return;
  }
  const float s = static_cast<float>(ui.scale);
  if (beginToolWindow(ui, "Points and badges", "###progress", ui.progressOpen, 620, 0)) {
    if (ImGui::BeginTable("lessons", 4, ImGuiTableFlags_RowBg)) {
      ImGui::TableSetupColumn("badge", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize());
      ImGui::TableSetupColumn("title", ImGuiTableColumnFlags_WidthStretch);
      ImGui::TableSetupColumn("steps", ImGuiTableColumnFlags_WidthFixed, 110 * s);
      ImGui::TableSetupColumn("points", ImGuiTableColumnFlags_WidthFixed, 120 * s);
      for (const LevelEntry& entry : ui.levels) {
        if (!entry.lesson.steps.empty()) lessonRow(entry, editor, ui);
      }
      ImGui::EndTable();
    }
    resetButton(editor, ui);
  }
  ImGui::End();
}

}  // namespace anamorph
