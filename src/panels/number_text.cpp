#include "panels/number_text.h"

#include <imgui_internal.h>

#include "base/language.h"

namespace anamorph {

NumberText::NumberText(const char* format, const double& value)
    : format_(format), value_(value), typed_(ImGui::TempInputIsActive(ImGui::GetID("##value"))) {
  if (typed_) {
    for (ImWchar& c : ImGui::GetIO().InputQueueCharacters) c = c == ',' ? '.' : c;
    return;
  }
  ImGui::PushStyleColor(ImGuiCol_Text, {0, 0, 0, 0});
}

NumberText::~NumberText() {
  if (typed_) return;
  ImGui::PopStyleColor();
  const std::string text = numberText(format_, value_);
  ImGui::RenderTextClipped(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), text.data(),
                           text.data() + text.size(), nullptr, {0.5f, 0.5f});
}

std::string numberText(const char* format, double value) {
  const char* const place = ImParseFormatFindStart(format);
  const char* const end = ImParseFormatFindEnd(place);
  if (place == end) return format;
  return std::string(format, place) + shownNumber(value, std::string_view(place + 1, end)) + end;
}

}  // namespace anamorph
