#include "panels/highlight.h"

#include <algorithm>
#include <cmath>

#include <imgui_internal.h>

#include "panels/style.h"

namespace anamorph {
namespace {

constexpr double highlightSeconds = 6;

// Around what is pointed at, over everything, breathing so that it is found.
void outline(Highlight& highlight, const ImVec2& low, const ImVec2& high) {
  if (!highlight.scrolled) ImGui::SetScrollHereY(0.3f);
  highlight.scrolled = true;
  ++highlight.outlined;
  const float pulse = 0.5f + 0.5f * static_cast<float>(std::sin(6 * (highlightSeconds - highlight.seconds)));
  const float grow = ImGui::GetFontSize() * (0.15f + 0.12f * pulse);
  const ImRect& room = ImGui::GetCurrentWindow()->ClipRect;
  if (!room.Overlaps({low, high})) return;
  ImGui::GetForegroundDrawList()->AddRect({low.x - grow, low.y - grow}, {high.x + grow, high.y + grow},
                                          ink::of(palette::pointedAt), grow, 0, 0.2f * ImGui::GetFontSize());
}

}  // namespace

void startHighlight(Highlight& highlight, const std::string& control, const LessonRun& run) {
  highlight.control = control;
  highlight.seconds = control.empty() ? 0 : highlightSeconds;
  highlight.step = openStepOf(run);
  highlight.moving = highlight.scrolled = false;
  highlight.frames = 0;
}

void advanceHighlight(Highlight& highlight, const LessonRun& run, double seconds) {
  const bool isOver = highlight.step != openStepOf(run) || (highlight.moving && !run.play);
  highlight.seconds = isOver ? 0 : std::max(0.0, highlight.seconds - seconds);
  if (highlight.seconds == 0) highlight.control.clear();
  ++highlight.frames;
}

HighlightScope::HighlightScope(Highlight& highlight) : before_(ImGui::GetIO().UserData) {
  ImGui::GetIO().UserData = &highlight;
}

HighlightScope::~HighlightScope() {
  ImGui::GetIO().UserData = before_;
}

bool isHighlightMissing() {
  const auto* highlight = static_cast<const Highlight*>(ImGui::GetIO().UserData);
  return highlight && !highlight->control.empty() && !highlight->scrolled && highlight->frames > 1;
}

void highlightArea(const char* control, const ImVec2& low, const ImVec2& high) {
  auto* highlight = static_cast<Highlight*>(ImGui::GetIO().UserData);
  if (highlight && !highlight->control.empty() && highlight->control == control)
    outline(*highlight, low, high);
}

void highlightItem(const char* control) {
  highlightArea(control, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

}  // namespace anamorph
