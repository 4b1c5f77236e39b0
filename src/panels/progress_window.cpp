#include "panels/progress_window.h"

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "edit/lesson_run.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

void lessonRow(const LevelEntry& entry, const Editor& editor, const Look& look) {
  const LessonScore score = scoreOf(entry.lesson, editor.progress);
  const float size = ImGui::GetFontSize();
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const ImVec2 p = ImGui::GetCursorScreenPos();
  if (score.badge) drawStar({p.x + size / 2, p.y + size / 2}, size / 2);
  ImGui::Dummy({size, size});
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(inOneLine(tr(entry.title)).c_str());
  if (score.badge) {
    quietText(look, fmt::format("{}: {}", tr(entry.lesson.badge.title), tr(entry.lesson.badge.text)).c_str());
  }
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(trFormat("{} of {} steps", score.done, score.steps).c_str());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(trFormat("{} of {} points", score.points, score.of).c_str());
}

// Asked twice, because it cannot be undone.
void resetButton(ProgressWindow& window, Editor& editor, const Look& look) {
  const bool any = !editor.progress.empty();
  if (!any) window.resetAsked = false;
  if (!window.resetAsked) {
    if (wideButton("Reset progress", "Forget all steps that were done.", any)) window.resetAsked = true;
    return;
  }
  quietText(look, "All points and badges will be gone.");
  if (wideButton("Yes, forget them")) {
    editor.progress.clear();
    openStep(editor, 0);
    window.resetAsked = false;
  }
  if (wideButton("Keep them")) window.resetAsked = false;
}

}  // namespace

void drawProgressWindow(ProgressWindow& window, Editor& editor, const std::vector<LevelEntry>& levels,
                        const Look& look) {
  if (!window.open) {
    window.resetAsked = false;
    return;
  }
  const float s = static_cast<float>(look.scale);
  if (beginToolWindow(look, "Points and badges", "###progress", window.open, 620, 0)) {
    if (ImGui::BeginTable("lessons", 4, ImGuiTableFlags_RowBg)) {
      ImGui::TableSetupColumn("badge", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize());
      ImGui::TableSetupColumn("title", ImGuiTableColumnFlags_WidthStretch);
      ImGui::TableSetupColumn("steps", ImGuiTableColumnFlags_WidthFixed, 110 * s);
      ImGui::TableSetupColumn("points", ImGuiTableColumnFlags_WidthFixed, 120 * s);
      for (const LevelEntry& entry : levels) {
        if (!entry.lesson.steps.empty()) lessonRow(entry, editor, look);
      }
      ImGui::EndTable();
    }
    resetButton(window, editor, look);
  }
  ImGui::End();
}

}  // namespace anamorph
