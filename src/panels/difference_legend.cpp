#include "panels/difference_legend.h"

#include <imgui.h>

#include "base/language.h"
#include "math/palette.h"
#include "panels/style.h"

namespace anamorph {
namespace {

// A square of the colour, and its meaning beside it.
float swatch() {
  return 0.7f * ImGui::GetFontSize();
}

float widthOf(const DifferenceColor& entry) {
  return swatch() + ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize(tr(entry.meaning)).x +
         ImGui::GetStyle().ItemSpacing.x;
}

void drawEntry(const DifferenceColor& entry) {
  const float size = swatch(), down = (ImGui::GetTextLineHeight() - size) / 2;
  const ImVec2 p = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled({p.x, p.y + down}, {p.x + size, p.y + down + size},
                                            ink::of(entry.color));
  ImGui::Dummy({size, ImGui::GetTextLineHeight()});
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  ImGui::TextUnformatted(tr(entry.meaning));
}

}  // namespace

DifferenceLegend::DifferenceLegend(bool reflects, float width) {
  std::vector<DifferenceColor> entries{
      {palette::grey, "Both"},
      {palette::onlyOriginal, "Only original"},
      {palette::onlyReflection, reflects ? "Only reflection" : "Only sculpture"},
      {palette::hiddenReflection, "Hidden"}};
  if (reflects) entries.push_back({palette::noMirror, "No mirror"});
  float used = width;
  for (const DifferenceColor& entry : entries) {
    const float own = widthOf(entry);
    if (used + own > width) {
      lines_.emplace_back();
      used = 0;
    }
    lines_.back().push_back(entry);
    used += own;
  }
}

float DifferenceLegend::height() const {
  return static_cast<float>(lines_.size()) * (ImGui::GetTextLineHeight() + ImGui::GetStyle().ItemSpacing.y);
}

void DifferenceLegend::draw() const {
  for (const auto& line : lines_) {
    for (const DifferenceColor& entry : line) {
      if (&entry != line.data()) ImGui::SameLine();
      drawEntry(entry);
    }
  }
}

}  // namespace anamorph
