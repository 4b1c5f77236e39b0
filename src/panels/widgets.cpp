#include "panels/widgets.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "base/language.h"
#include "base/text.h"
#include "panels/highlight.h"
#include "panels/number_breaks.h"
#include "panels/number_text.h"
#include "panels/style.h"
#include "panels/typing_limit.h"

namespace anamorph {
namespace {

constexpr float nameFraction = 0.40f;             // of the width
constexpr float mostNameFraction = 0.55f;         // for a longer name
constexpr std::size_t mostParagraphBytes = 4000;  // Dear ImGui ends the program at 16384 letters

// Outlines the row that begins here when it is pointed at.
void highlightRow(const char* name, float width) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  highlightArea(name, low, {low.x + width, low.y + ImGui::GetFrameHeight()});
}

// Writes the name and moves to where the control goes. Pair with endRow().
void beginRow(const char* name, const char* help) {
  ImGui::PushID(name);
  const float width = ImGui::GetContentRegionAvail().x;
  highlightRow(name, width);
  const float start = ImGui::GetCursorPosX();
  const float nameWidth = ImGui::CalcTextSize(tr(name)).x + ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(tr(name));
  tooltip(help);
  const float column = std::max(nameFraction * width, nameWidth);
  if (column > mostNameFraction * width) {  // the control has the next line for itself
    ImGui::SetNextItemWidth(width);
    return;
  }
  ImGui::SameLine();
  ImGui::SetCursorPosX(start + column);
  ImGui::SetNextItemWidth(width - column);
}

void endRow(const char* help) {
  tooltip(help);
  ImGui::PopID();
}

bool dragNumber(double& value, const NumberRange& range) {
  const NumberText text(range.format, value);
  return ImGui::DragScalar("##value", ImGuiDataType_Double, &value, static_cast<float>(range.speed),
                           &range.min, &range.max, range.format, ImGuiSliderFlags_AlwaysClamp);
}

// What is typed may be a calculation ("*1e999"), and ranges let nan pass.
bool takeFinite(bool changed, double& value, double before) {
  if (!changed || std::isfinite(value)) return changed;
  value = before;
  return false;
}

}  // namespace

std::string label(const char* english) {
  return std::string(tr(english)) + "###" + english;
}

bool beginToolWindow(const Look& look, const char* english, const char* id, bool& open, float width,
                     float height, float mostHeight) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float s = static_cast<float>(look.scale);
  const bool fits = height <= 0;
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(width * s, display.x), std::min(height * s, mostHeight * display.y)},
                           fits ? ImGuiCond_Always : ImGuiCond_Appearing);
  const int flags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
  const std::string title = std::string(tr(english)) + id;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, std::max(1.0f, std::round(s)));
  const bool shown = ImGui::Begin(title.c_str(), &open, fits ? flags | ImGuiWindowFlags_NoResize : flags);
  ImGui::PopStyleVar();
  return shown;
}

bool section(const Look& look, const char* title, bool open) {
  ImGui::Dummy({0, 2});
  const FontScope strong(look.fonts.strong);
  ImGui::PushStyleColor(ImGuiCol_Header, {0, 0, 0, 0});
  ImGui::SetNextItemOpen(open, ImGuiCond_Once);
  if (isHighlightMissing()) ImGui::SetNextItemOpen(true);
  const bool shown = ImGui::CollapsingHeader(label(title).c_str());
  ImGui::PopStyleColor();
  return shown;
}

bool numberRow(const char* name, double& value, const NumberRange& range, const char* help) {
  beginRow(name, help);
  const double before = value;
  const bool changed = dragNumber(value, range);
  endRow(help);
  return takeFinite(changed, value, before);
}

// A double click types into a slider, as into all other numbers: for Dear ImGui 1.86 that is a click with Ctrl.
class TypeByDoubleClick {
 public:
  TypeByDoubleClick() : control_(ImGui::GetIO().KeyCtrl) {
    if (ImGui::IsMouseDoubleClicked(0)) ImGui::GetIO().KeyCtrl = true;
  }
  ~TypeByDoubleClick() { ImGui::GetIO().KeyCtrl = control_; }
  TypeByDoubleClick(const TypeByDoubleClick&) = delete;
  TypeByDoubleClick& operator=(const TypeByDoubleClick&) = delete;

 private:
  bool control_;
};

bool sliderRow(const char* name, double& value, const NumberRange& range, const char* help,
               bool logarithmic) {
  beginRow(name, help);
  const int flags = ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
  const double before = value;
  const TypeByDoubleClick types;
  bool changed = false;
  {
    const NumberText text(range.format, value);
    changed = ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &range.min, &range.max,
                                  range.format, flags);
  }
  endRow(help);
  return takeFinite(changed, value, before);
}

bool integerRow(const char* name, int& value, const Range& range, const char* help) {
  beginRow(name, help);
  const TypeByDoubleClick types;
  const bool changed = ImGui::SliderInt("##value", &value, static_cast<int>(range.min),
                                        static_cast<int>(range.max), "%d", ImGuiSliderFlags_AlwaysClamp);
  endRow(help);
  return changed;
}

bool vectorRow(const char* name, Vector& value, const NumberRange& range, const char* help) {
  beginRow(name, help);
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x, width = (ImGui::CalcItemWidth() - 2 * gap) / 3;
  bool changed = false;
  for (int axis = 0; axis < 3; ++axis) {
    ImGui::PushID(axis);
    if (axis > 0) ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(width);
    const double before = value[axis];
    const bool dragged = dragNumber(value[axis], range);
    changed |= takeFinite(dragged, value[axis], before);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float thickness = std::max(2.0f, 0.09f * (high.y - low.y));
    ImGui::GetWindowDrawList()->AddRectFilled({low.x + 3, high.y - thickness}, {high.x - 3, high.y},
                                              ink::of(palette::fieldAxes[static_cast<std::size_t>(axis)]),
                                              thickness / 2);
    tooltip(help);
    ImGui::PopID();
  }
  ImGui::PopID();
  return changed;
}

bool checkRow(const char* name, bool& value, const char* help) {
  const bool changed = ImGui::Checkbox(label(name).c_str(), &value);
  highlightItem(name);
  tooltip(help);
  return changed;
}

bool colorRow(const char* name, Color& value, const char* help) {
  beginRow(name, help);
  float display[3];
  for (int i = 0; i < 3; ++i) display[i] = static_cast<float>(displayOf(value[i]));
  const bool changed = ImGui::ColorEdit3("##value", display, ImGuiColorEditFlags_Float);
  if (changed) {
    for (int i = 0; i < 3; ++i) {
      if (std::isfinite(display[i])) value[i] = std::clamp(lightOf(display[i]), 0.0, 1.0);
    }
  }
  endRow(help);
  return changed;
}

bool choiceRow(const char* name, int& value, const std::vector<const char*>& choices, const char* help) {
  beginRow(name, help);
  std::vector<const char*> names;
  for (const char* choice : choices) names.push_back(tr(choice));
  const bool changed = ImGui::Combo("##value", &value, names.data(), static_cast<int>(names.size()));
  endRow(help);
  return changed;
}

bool textFieldRow(const char* name, std::string& value, std::size_t most, const char* help) {
  TypingLimit limit(value, most);
  beginRow(name, help);
  const bool changed = ImGui::InputText("##value", &value, ImGuiInputTextFlags_CallbackCharFilter,
                                        TypingLimit::filter, &limit);
  endRow(help);
  return changed;
}

void textRow(const char* name, const std::string& value, const char* help) {
  beginRow(name, help);
  paragraph(value);
  endRow(help);
}

void drawStar(const ImVec2& middle, float radius) {
  constexpr ImU32 gold = ink::of(palette::badge);
  constexpr int points = 5;
  const auto at = [&](float turn, float r) {
    const float angle = (turn / points - 0.25f) * 2 * 3.14159265f;
    return ImVec2{middle.x + r * std::cos(angle), middle.y + r * std::sin(angle)};
  };
  ImDrawList* list = ImGui::GetWindowDrawList();
  constexpr float inner = 0.5f;
  std::vector<ImVec2> core;
  for (int i = 0; i < points; ++i) {
    const auto turn = static_cast<float>(i);
    list->AddTriangleFilled(at(turn - 0.5f, inner * radius), at(turn, radius),
                            at(turn + 0.5f, inner * radius), gold);
    core.push_back(at(turn + 0.5f, inner * radius));
  }
  list->AddConvexPolyFilled(core.data(), points, gold);
}

void tooltip(const char* text) {
  if (*text == 0 || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  // Dear ImGui 1.86 has no delay of its own: the time that the mouse has rested is counted here.
  ImGuiStorage* storage = ImGui::GetStateStorage();
  const ImGuiID key = ImGui::GetID("tooltip");
  const ImGuiIO& io = ImGui::GetIO();
  const bool moved = std::abs(io.MouseDelta.x) + std::abs(io.MouseDelta.y) > 0;
  constexpr float afterClick = -10;  // who has pressed it wants to see what it did
  float rested = moved ? 0 : storage->GetFloat(key) + io.DeltaTime;
  if (ImGui::IsAnyMouseDown()) rested = afterClick;
  storage->SetFloat(key, rested);
  if (rested < 0.5f) return;
  // Below the control, or above it at the lower edge: under the mouse it would cover what it tells of.
  const float wide = ImGui::GetFontSize() * 22, gap = 4;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax(), size = io.DisplaySize;
  const std::string shown = shortened(tr(text), mostParagraphBytes);
  const ImVec2 extent = ImGui::CalcTextSize(shown.c_str(), nullptr, false, wide);
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  const bool below = high.y + gap + extent.y + 2 * padding.y < size.y;
  const float x = std::max(0.0f, std::min(low.x, size.x - extent.x - 2 * padding.x));
  ImGui::SetNextWindowPos({x, below ? high.y + gap : low.y - gap}, ImGuiCond_Always,
                          {0, below ? 0.0f : 1.0f});
  ImGui::BeginTooltip();
  paragraph(shown, wide);
  ImGui::EndTooltip();
}

void letGoOfWidgets() {
  if (ImGui::GetCurrentContext()) ImGui::ClearActiveID();
}

bool closePopups() {
  if (!ImGui::GetCurrentContext() || ImGui::GetCurrentContext()->OpenPopupStack.empty()) return false;
  ImGui::ClosePopupToLevel(0, true);
  return true;
}

void paragraph(const std::string& text, float wrapAt) {
  ImGui::PushTextWrapPos(wrapAt);
  ImGui::TextUnformatted(numbersTogether(shortened(text, mostParagraphBytes)).c_str());
  ImGui::PopTextWrapPos();
}

float paragraphHeight(const std::string& text, float width) {
  const std::string shown = numbersTogether(shortened(text, mostParagraphBytes));
  return ImGui::CalcTextSize(shown.c_str(), nullptr, false, width).y;
}

std::string inOneLine(const std::string& text) {
  return shortened(text, 300);
}

void quietText(const Look& look, const char* text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ink::quiet(look.theme));
  paragraph(tr(text));
  ImGui::PopStyleColor();
}

std::string capitalised(std::string sentence) {
  if (!sentence.empty() && sentence[0] >= 'a' && sentence[0] <= 'z')
    sentence[0] = static_cast<char>(sentence[0] - 32);
  return sentence;
}

void problemText(const Look& look, const std::string& text) {
  if (text.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, ink::bad(look.theme));
  paragraph(capitalised(tr(text)));
  ImGui::PopStyleColor();
}

bool wideButton(const char* name, const char* help, bool enabled) {
  ImGui::BeginDisabled(!enabled);
  const bool pressed = ImGui::Button(label(name).c_str(), {-FLT_MIN, 0});
  ImGui::EndDisabled();
  highlightItem(name);
  tooltip(help);
  return pressed;
}

bool fittedButton(const char* name, float width) {
  constexpr float leastPadding = 1;
  const ImVec2 padding = ImGui::GetStyle().FramePadding;
  const float spare = (width - ImGui::CalcTextSize(tr(name)).x) / 2;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {std::clamp(spare, leastPadding, padding.x), padding.y});
  const bool pressed = ImGui::Button(label(name).c_str(), {width, 0});
  ImGui::PopStyleVar();
  return pressed;
}

int columnsFor(const std::vector<const char*>& names, int columns, float gap) {
  float longest = 0;
  for (const char* name : names) longest = std::max(longest, ImGui::CalcTextSize(tr(name)).x);
  const float room = ImGui::GetContentRegionAvail().x + gap;
  const int fit = std::clamp(static_cast<int>(room / (longest + 2 + gap)), 1, columns);
  if (fit == columns) return columns;
  const int count = static_cast<int>(names.size()), rows = (count + fit - 1) / fit;
  return (count + rows - 1) / rows;
}

bool segmentedControl(const char* id, int& chosen, const std::vector<const char*>& names, int columns) {
  ImGui::PushID(id);
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x * 0.5f;
  columns = columnsFor(names, columns, gap);
  const float width = (ImGui::GetContentRegionAvail().x - gap * static_cast<float>(columns - 1)) /
                      static_cast<float>(columns);
  bool changed = false;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  for (int i = 0; i < static_cast<int>(names.size()); ++i) {
    if (i % columns != 0) ImGui::SameLine(0, gap);
    const bool on = i == chosen;
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
    if (fittedButton(names[i], width)) {
      chosen = i;
      changed = true;
    }
    highlightItem(names[i]);
    if (on) ImGui::PopStyleColor();
  }
  ImGui::PopStyleVar();
  ImGui::PopID();
  return changed;
}

bool beginPanel(const char* name, const Rect& rect, bool padded, bool scrolls) {
  if (rect.empty()) return false;
  ImGui::SetNextWindowPos({rect.x, rect.y});
  ImGui::SetNextWindowSize({rect.width, rect.height});
  int flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
              ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
              ImGuiWindowFlags_NoBringToFrontOnFocus;
  if (!scrolls) flags |= ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  if (!padded) ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(name, nullptr, flags);
  ImGui::PopStyleVar(padded ? 1 : 2);
  return true;
}

}  // namespace anamorph
