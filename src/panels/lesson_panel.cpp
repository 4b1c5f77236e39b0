// The lesson of the open level: one step at a time, with what to do and a way on.

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "panels/actions.h"
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
  const std::string points = fmt::format(fmt::runtime(tr("{} of {} points")), score.points, score.of);
  const float x = ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(points.c_str()).x;
  ImGui::SameLine(x);
  quietText(ui, points.c_str());
}

// The way on is the most visible button when there is nothing left to do here.
bool button(const char* name, const char* help, float width, bool enabled, bool strong) {
  if (strong) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
  ImGui::BeginDisabled(!enabled);
  const bool pressed = fittedButton(name, width);
  ImGui::EndDisabled();
  if (strong) ImGui::PopStyleColor();
  tooltip(help);
  return pressed;
}

void drawButtons(Editor& editor, UiState& ui) {
  const LessonRun& run = editor.lesson;
  const bool last = run.step + 1 == run.lesson.steps.size(), reads = run.open().done.empty();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float half = (ImGui::GetContentRegionAvail().x - gap) / 2;
  if (button("Show me", "Points at the control, and makes the move of this step.", half, canShow(run),
             false)) {
    showStep(editor, ui);
  }
  ImGui::SameLine();
  const char* reset = ImGui::CalcTextSize(tr("Reset the level")).x > half ? "Reset" : "Reset the level";
  if (button(reset, "As it was opened. Can be undone.", half, editor.session.modified(), false)) {
    perform(Action::resetLevel, editor, ui);
  }
  if (button("Back", "The step before.", half, run.step > 0, false))
    perform(Action::previousStep, editor, ui);
  ImGui::SameLine();
  const bool readLast = last && reads && !run.done;
  if (last && !readLast) {
    const bool more = hasNextLevel(editor, ui);
    if (button("Next level", "", half, more, run.done)) perform(Action::nextLevel, editor, ui);
    return;
  }
  const char* name = readLast ? "Done" : run.done || reads ? "Next" : "Skip";
  if (button(name, "The next step.", half, true, run.done || reads)) perform(Action::nextStep, editor, ui);
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
    ImGui::TextUnformatted(tr(run.lesson.badge.title.c_str()));
  }
  quietText(ui, run.lesson.badge.text.c_str());
}

void drawLesson(Editor& editor, UiState& ui) {
  drawHead(editor, ui);
  const ImGuiStyle& style = ImGui::GetStyle();
  const float buttons = 2 * ImGui::GetFrameHeight() + 3 * style.ItemSpacing.y;
  ImGui::BeginChild("step", {0, std::max(40.0f, ImGui::GetContentRegionAvail().y - buttons)}, false,
                    ImGuiWindowFlags_NavFlattened);
  constexpr int layoutFrames = 3;  // until the height of what has been added is known
  const StepOfLesson step = openStepOf(editor.lesson);
  if (ui.scrolledStep != step) {
    ImGui::SetScrollY(0);
    ui.noticeFrames = 0;
  } else if (editor.lesson.done && !ui.wasDone) {
    ui.noticeFrames = layoutFrames;
  }
  ui.scrolledStep = step;
  ui.wasDone = editor.lesson.done;
  title(ui, editor.lesson.open().title);
  drawStepText(editor.lesson, ui);
  drawBadge(editor, ui);
  // What there is to notice must not appear below the edge.
  if (ui.noticeFrames > 0) {
    ImGui::SetScrollHereY(1);
    --ui.noticeFrames;
  }
  ImGui::EndChild();
  drawButtons(editor, ui);
}

void drawDescription(Editor& editor, UiState& ui) {
  const Level& level = editor.session.level();
  title(ui, level.text->title.empty() ? "A level without a title" : level.text->title);
  paragraph(tr(level.text->description));
  if (level.text->title.empty()) quietText(ui, "Give it one in the tab View.");
  ImGui::Dummy({0, ImGui::GetStyle().ItemSpacing.y});
  if (wideButton("Reset the level", "As it was opened. Can be undone.", editor.session.modified())) {
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
