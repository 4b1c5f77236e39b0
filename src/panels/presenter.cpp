// For an audience: the open step at the bottom of the view in large letters, and a ring around the mouse.

#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "panels/lesson_text.h"
#include "panels/panels.h"
#include "panels/style.h"

namespace anamorph {
namespace {

void drawMouseMark(const UiState& ui) {
  if (!ImGui::IsMousePosValid()) return;
  const float s = static_cast<float>(ui.scale);
  const bool down = ImGui::IsMouseDown(0) || ImGui::IsMouseDown(1);
  ImDrawList* list = ImGui::GetForegroundDrawList();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  list->AddCircleFilled(mouse, (down ? 18 : 24) * s, ink::of(palette::mouseDisc, down ? 120 : 70));
  list->AddCircle(mouse, (down ? 18 : 24) * s, ink::of(palette::mouseRing, 230), 0, 2.5f * s);
}

void words(const LessonRun& run, UiState& ui) {
  const LessonStep& step = run.open();
  {
    const FontScope strong(ui.fonts.strong);
    ImGui::TextColored(ink::accent(ui.theme), "%s   %s", stepCount(run).c_str(), tr(step.title.c_str()));
  }
  const FontScope huge(ui.fonts.huge);
  // What was done while rehearsing is no answer yet.
  const bool notice = run.doneNow && !step.notice.empty();
  if (notice) ImGui::PushStyleColor(ImGuiCol_Text, ink::good(ui.theme));
  ui.longTexts.draw(notice ? step.notice : isAnswered(run) ? step.task : step.question->text);
  if (notice) ImGui::PopStyleColor();
}

}  // namespace

void drawPresenter(Editor& editor, UiState& ui) {
  if (!ui.presenting) return;
  drawMouseMark(ui);
  if (editor.lesson.empty()) return;
  const Rect& view = ui.layout.view;
  const float s = static_cast<float>(ui.scale), width = std::min(view.width - 40 * s, 1000 * s);
  ImGui::SetNextWindowPos({view.x + view.width / 2, view.y + view.height - 58 * s}, ImGuiCond_Always,
                          {0.5f, 1});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::SetNextWindowBgAlpha(0.88f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 10 * s);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {20 * s, 14 * s});
  ImGui::Begin("##presenter", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoInputs);
  words(editor.lesson, ui);
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace anamorph
