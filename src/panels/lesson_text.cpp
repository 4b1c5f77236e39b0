#include "panels/lesson_text.h"

#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "edit/lesson_run.h"
#include "edit/lesson_start.h"
#include "panels/figures.h"
#include "panels/highlight.h"
#include "panels/property_tabs.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

float barInset(const Look& look) {
  return 11 * static_cast<float>(look.scale);
}

// Text beside a bar of some colour.
void barred(const std::string& text, const ImVec4& color, LongTexts& texts, const Look& look) {
  const float s = static_cast<float>(look.scale), inset = barInset(look);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  ImGui::Indent(inset);
  texts.draw(text);
  ImGui::Unindent(inset);
  const float to = ImGui::GetCursorScreenPos().y - ImGui::GetStyle().ItemSpacing.y;
  ImGui::GetWindowDrawList()->AddRectFilled({from.x, from.y}, {from.x + 4 * s, to},
                                            ImGui::ColorConvertFloat4ToU32(color), 2 * s);
}

// The level is not what the step needs, because another one was left out or done otherwise.
void offerStart(Editor& editor, UiState& ui) {
  const LessonRun& run = editor.lesson;
  if (run.done || !isStartMissed(run, run.begin.level) || !isStartMissed(run, editor.session.level())) return;
  quietText(ui, "This step begins with other settings than you have now.");
  if (ImGui::Button(tr("Set it up"))) openStep(editor, editor.lesson.step);
  tooltip("With the level that it is meant to begin with; can be undone");
}

float answerInset() {
  return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
}

void drawQuestion(Editor& editor, UiState& ui) {
  const LessonRun& run = editor.lesson;
  const auto& question = run.open().question;
  if (!question) return;
  {
    const FontScope strong(ui.fonts.strong);
    ui.longTexts.draw(question->text);
  }
  drawAnswers(editor, ui);
  if (!run.answer) return;
  const StepAnswer& given = question->answers[*run.answer];
  barred(given.reply, given.right ? ink::good(ui.theme) : ink::bad(ui.theme), ui.longTexts, ui);
}

}  // namespace

// Longer ones than the panel is wide are wrapped, and a click on the words is one on the circle.
void drawAnswers(Editor& editor, UiState& ui) {
  const LessonRun& run = editor.lesson;
  const auto& answers = run.open().question->answers;
  ImGui::BeginDisabled(isAnswered(run));
  for (std::size_t i = 0; i < answers.size(); ++i) {
    bool given = ImGui::RadioButton(fmt::format("###{}", i).c_str(), run.answer == i);
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::BeginGroup();
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + ImGui::GetStyle().FramePadding.y);
    ui.longTexts.draw(answers[i].text);
    ImGui::EndGroup();
    given |= ImGui::IsItemClicked() && !isAnswered(run);
    if (given) answerStep(editor, i);
  }
  ImGui::EndDisabled();
}

float answersHeight(const LessonRun& run, float width) {
  if (!run.open().question) return 0;
  float height = 0;
  for (const StepAnswer& answer : run.open().question->answers) {
    height += paragraphHeight(tr(answer.text), width - answerInset()) + ImGui::GetStyle().FramePadding.y +
              ImGui::GetStyle().ItemSpacing.y;
  }
  return height;
}

void drawTask(const LessonRun& run, UiState& ui) {
  barred(run.open().task, run.done ? ink::good(ui.theme) : ink::accent(ui.theme), ui.longTexts, ui);
}

float taskHeight(const LessonRun& run, const Look& look, float width) {
  return paragraphHeight(tr(run.open().task), width - barInset(look)) + ImGui::GetStyle().ItemSpacing.y;
}

void drawStepText(Editor& editor, UiState& ui, bool withTask) {
  const LessonRun& run = editor.lesson;
  const LessonStep& step = run.open();
  const auto gap = [] { ImGui::Dummy({0, ImGui::GetStyle().ItemSpacing.y / 2}); };
  ui.longTexts.draw(step.why);
  gap();
  if (!step.figure.empty()) drawFigure(step.figure, ui);
  offerStart(editor, ui);
  drawQuestion(editor, ui);
  if (!isAnswered(run)) return;
  if (withTask) drawTask(run, ui);
  if (!run.done || step.notice.empty()) return;
  gap();
  barred(step.notice, ink::good(ui.theme), ui.longTexts, ui);
}

void drawStepDots(Editor& editor, const Look& look) {
  const LessonRun& run = editor.lesson;
  const float s = static_cast<float>(look.scale);
  const auto count = static_cast<float>(run.lesson.steps.size());
  const float room = ImGui::GetContentRegionAvail().x, cell = std::min(22 * s, room / std::max(1.0f, count));
  const float height = 20 * s;
  ImDrawList* list = ImGui::GetWindowDrawList();
  std::optional<std::size_t> wanted;
  for (std::size_t i = 0; i < run.lesson.steps.size(); ++i) {
    const LessonStep& step = run.lesson.steps[i];
    const bool done = isDone(run.lesson, step, editor.progress), open = i == run.step;
    ImGui::PushID(static_cast<int>(i));
    if (i > 0) ImGui::SameLine(0, 0);
    const ImVec2 p = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("dot", {cell, height})) wanted = i;
    const ImVec2 middle{p.x + cell / 2, p.y + height / 2};
    const float r = (step.optional ? 3.4f : 5) * s;
    const ImU32 color = ImGui::ColorConvertFloat4ToU32(done ? ink::good(look.theme) : ink::quiet(look.theme));
    if (done) {
      list->AddCircleFilled(middle, r, color);
    } else {
      list->AddCircle(middle, r, color, 0, 1.6f * s);
    }
    if (open) {
      list->AddCircle(middle, 8 * s, ImGui::ColorConvertFloat4ToU32(ink::accent(look.theme)), 0, 2 * s);
    }
    tooltip(step.optional ? fmt::format("{} ({})", tr(step.title), tr("optional")).c_str()
                          : step.title.c_str());
    ImGui::PopID();
  }
  if (wanted) openStep(editor, *wanted);
}

std::string stepCount(const LessonRun& run) {
  return trFormat("Step {} of {}", run.step + 1, run.lesson.steps.size());
}

bool canPointAt(const LessonRun& run) {
  return !run.empty() && !(run.open().show.widget.empty() && run.open().show.tab.empty());
}

bool canPlay(const LessonRun& run) {
  return !run.empty() && run.open().show.play;
}

void pointAtStep(Editor& editor, UiState& ui) {
  if (editor.lesson.empty()) return;
  const StepShow& show = editor.lesson.open().show;
  if (!ui.presenting) ui.panelsHidden = false;
  const auto tab = std::find(stepTabs.begin(), stepTabs.end(), show.tab);
  if (tab != stepTabs.end())
    openTab(ui.tabs, editor.selection, static_cast<PropertyTab>(tab - stepTabs.begin()));
  startHighlight(ui.highlight, show.widget, editor.lesson);
}

void doStep(Editor& editor, UiState& ui) {
  pointAtStep(editor, ui);
  playStep(editor);
  ui.highlight.moving = true;
}

}  // namespace anamorph
