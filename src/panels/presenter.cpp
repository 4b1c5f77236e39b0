// For an audience: the open step below the view in large letters, and a ring around the mouse.

#include <algorithm>

#include <imgui.h>

#include "base/language.h"
#include "panels/lesson_text.h"
#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"

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

ImVec2 paddingOf(const UiState& ui) {
  const float s = static_cast<float>(ui.scale);
  return {20 * s, 12 * s};
}

void words(Editor& editor, UiState& ui) {
  const LessonRun& run = editor.lesson;
  const LessonStep& step = run.open();
  {
    const FontScope strong(ui.fonts.strong);
    ImGui::TextColored(ink::accent(ui.theme), "%s   %s", stepCount(run).c_str(), tr(step.title.c_str()));
  }
  // What was done while rehearsing is no answer yet.
  const bool notice = run.doneNow && !step.notice.empty();
  const bool asks = !notice && !isAnswered(run);
  {
    const FontScope huge(ui.fonts.huge);
    if (notice) ImGui::PushStyleColor(ImGuiCol_Text, ink::good(ui.theme));
    ui.longTexts.draw(notice ? step.notice : asks ? step.question->text : step.task);
    if (notice) ImGui::PopStyleColor();
  }
  if (!asks) return;
  const FontScope strong(ui.fonts.strong);
  drawAnswers(editor, ui);
}

}  // namespace

float presenterHeight(const Editor& editor, const UiState& ui) {
  if (!ui.presenting || editor.lesson.empty()) return 0;
  const LessonStep& step = editor.lesson.open();
  const ImVec2 padding = paddingOf(ui);
  const float width = ImGui::GetIO().DisplaySize.x - 2 * padding.x;
  float text = 0;
  {
    const FontScope huge(ui.fonts.huge);
    for (const std::string* words :
         {&step.task, &step.notice, step.question ? &step.question->text : nullptr})
      if (words) text = std::max(text, paragraphHeight(tr(*words), width));
  }
  const FontScope strong(ui.fonts.strong);
  if (!isAnswered(editor.lesson)) text += answersHeight(editor.lesson, width);
  return text + ImGui::GetTextLineHeight() + ImGui::GetStyle().ItemSpacing.y + 2 * padding.y;
}

void drawPresenter(Editor& editor, UiState& ui) {
  if (!ui.presenting) return;
  drawMouseMark(ui);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, paddingOf(ui));
  if (!editor.lesson.empty() && beginPanel("##presenter", ui.layout.words)) {
    words(editor, ui);
    ImGui::End();
  }
  ImGui::PopStyleVar();
}

}  // namespace anamorph
