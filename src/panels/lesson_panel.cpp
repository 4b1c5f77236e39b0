// The lesson of the open level: one step at a time, with what to do and a way on.

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "panels/actions.h"
#include "panels/lesson_scroll.h"
#include "panels/lesson_text.h"
#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

void title(const UiState& ui, const std::string& text) {
  const FontScope large(ui.fonts.title);
  paragraph(tr(text));
}

void drawHead(Editor& editor, UiState& ui) {
  const LessonRun& run = editor.lesson;
  const LessonScore score = scoreOf(run.lesson, editor.progress);
  drawStepDots(editor, ui);
  std::string line = stepCount(run);
  if (run.open().optional) line += fmt::format(", {}", tr("optional"));
  quietText(ui, line.c_str());
  const std::string points = trFormat("{} of {} points", score.points, score.of);
  const float x = ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(points.c_str()).x;
  const float end = ImGui::GetCursorStartPos().x + ImGui::CalcTextSize(line.c_str()).x;
  if (end + ImGui::GetStyle().ItemSpacing.x <= x) ImGui::SameLine(x);  // else below
  quietText(ui, points.c_str());
}

// Does an action, under a name of its own. The way on is the most visible button when there is nothing left to do here.
void button(Action action, const char* name, const char* help, float width, bool strong, Editor& editor,
            UiState& ui) {
  if (strong) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
  ImGui::BeginDisabled(!isEnabled(action, editor, ui));
  const bool pressed = fittedButton(name, width);
  ImGui::EndDisabled();
  if (strong) ImGui::PopStyleColor();
  tooltip(help);
  if (pressed) perform(action, editor, ui);
}

void drawButtons(Editor& editor, UiState& ui) {
  const LessonRun& run = editor.lesson;
  const bool last = run.step + 1 == run.lesson.steps.size(), reads = isOnlyRead(run.open());
  const bool readLast = last && reads && !run.done, onward = run.done || reads, done = run.done;
  const float gap = ImGui::GetStyle().ItemSpacing.x, room = ImGui::GetContentRegionAvail().x;
  const float half = (room - gap) / 2, third = (room - 2 * gap) / 3;
  for (const Action action : {Action::pointAtStep, Action::playStep}) {
    button(action, rowOf(action).name, rowOf(action).help, third, false, editor, ui);
    ImGui::SameLine();
  }
  button(Action::restartStep, "Again", rowOf(Action::restartStep).help, third, false, editor, ui);
  button(Action::previousStep, "Back", "The step before.", half, false, editor, ui);
  ImGui::SameLine();
  if (last && !readLast) return button(Action::nextLevel, "Next level", "", half, done, editor, ui);
  const char* name = readLast ? "Done" : onward ? "Next" : "Skip";
  button(Action::nextStep, name, "The next step.", half, onward, editor, ui);
}

void drawBadge(const Editor& editor, const UiState& ui) {
  const LessonRun& run = editor.lesson;
  if (!scoreOf(run.lesson, editor.progress).badge) return;
  ImGui::Dummy({0, ImGui::GetStyle().ItemSpacing.y});
  const float size = ImGui::GetFontSize();
  const ImVec2 p = ImGui::GetCursorScreenPos();
  drawStar({p.x + size / 2, p.y + size / 2}, size / 2);
  ImGui::Dummy({size, size});
  ImGui::SameLine();
  {
    const FontScope strong(ui.fonts.strong);
    ImGui::TextUnformatted(inOneLine(tr(run.lesson.badge.title)).c_str());
  }
  quietText(ui, run.lesson.badge.text.c_str());
}

void drawLesson(Editor& editor, UiState& ui) {
  drawHead(editor, ui);
  const ImGuiStyle& style = ImGui::GetStyle();
  const float buttons = 2 * ImGui::GetFrameHeight() + 3 * style.ItemSpacing.y;
  ImGui::BeginChild("step", {0, std::max(40.0f, ImGui::GetContentRegionAvail().y - buttons)}, false,
                    ImGuiWindowFlags_NavFlattened);
  scrollToStep(ui.lessonScroll, editor.lesson);
  title(ui, editor.lesson.open().title);
  drawStepText(editor, ui);
  drawBadge(editor, ui);
  scrollToNotice(ui.lessonScroll);  // which must not appear below the edge
  ImGui::EndChild();
  drawButtons(editor, ui);
}

void drawDescription(Editor& editor, UiState& ui) {
  const Level& level = editor.session.level();
  title(ui, level.text->title.empty() ? "A level without a title" : level.text->title);
  ui.longTexts.draw(level.text->description);
  if (level.text->title.empty()) quietText(ui, "Give it one in the tab View.");
  ImGui::Dummy({0, ImGui::GetStyle().ItemSpacing.y});
  if (wideButton("Reset the level", "As it was opened. Can be undone.",
                 isEnabled(Action::resetLevel, editor, ui))) {
    perform(Action::resetLevel, editor, ui);
  }
}

}  // namespace

void drawLessonPanel(Editor& editor, UiState& ui) {
  if (!beginPanel("lesson", ui.layout.lesson)) return;
  if (editor.lesson.empty()) {
    drawDescription(editor, ui);
  } else {
    drawLesson(editor, ui);
  }
  ImGui::End();
}

}  // namespace anamorph
