// The lesson of the open level: one step at a time, with what to do and a way on.

#include <algorithm>
#include <string>
#include <vector>

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

constexpr Action helpers[] = {Action::pointAtStep, Action::playStep, Action::restartStep};

const char* nameOf(Action action) {
  return action == Action::restartStep ? "Again" : rowOf(action).name;
}

int helperColumns() {
  std::vector<const char*> names;
  for (const Action action : helpers) names.push_back(nameOf(action));
  return columnsFor(names, static_cast<int>(names.size()), ImGui::GetStyle().ItemSpacing.x);
}

float buttonsHeight() {
  const int rows = helperColumns() == 3 ? 2 : 3;
  return static_cast<float>(rows) * ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
}

void drawHelpers(Editor& editor, UiState& ui) {
  const int columns = helperColumns();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gap * static_cast<float>(columns - 1)) /
                      static_cast<float>(columns);
  int i = 0;
  for (const Action action : helpers) {
    if (i++ % columns != 0) ImGui::SameLine();
    button(action, nameOf(action), rowOf(action).help, width, false, editor, ui);
  }
}

void drawButtons(Editor& editor, UiState& ui) {
  const LessonRun& run = editor.lesson;
  const bool last = run.step + 1 == run.lesson.steps.size(), reads = isOnlyRead(run.open());
  const bool readLast = last && reads && !run.done, onward = run.done || reads, done = run.done;
  drawHelpers(editor, ui);
  const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
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

// What to do must not be out of sight: where not all of the text has room, it stands below what scrolls.
void drawLesson(Editor& editor, UiState& ui) {
  const LessonRun& run = editor.lesson;
  drawHead(editor, ui);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float height = std::max(40.0f, room.y - buttonsHeight());
  const bool isOpen = !run.done && isAnswered(run), pinned = ui.lessonScroll.taskPinned && isOpen;
  const float task = pinned ? std::min(taskHeight(run, ui, room.x), height / 2) : 0;
  ImGui::BeginChild("step", {0, height - task}, false, ImGuiWindowFlags_NavFlattened);
  scrollToStep(ui.lessonScroll, run);
  title(ui, run.open().title);
  drawStepText(editor, ui, !pinned);
  drawBadge(editor, ui);
  scrollToNotice(ui.lessonScroll);  // which must not appear below the edge
  const float needed = ImGui::GetCursorPosY() + task;
  ImGui::EndChild();
  if (pinned) drawTask(run, ui);
  ui.lessonScroll.taskPinned = isOpen && needed > height + ImGui::GetStyle().ItemSpacing.y;
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
