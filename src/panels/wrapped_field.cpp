#include "panels/wrapped_field.h"

#include <algorithm>
#include <cfloat>

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "base/language.h"
#include "panels/highlight.h"
#include "panels/typing_limit.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

enum FieldState { shown, begins, typed };

// Returns whether a click begins typing.
bool drawWrapped(const std::string& text, float leastHeight) {
  const ImVec2 padding = ImGui::GetStyle().FramePadding, p = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, room = width - 2 * padding.x;
  const float height = std::max(leastHeight, paragraphHeight(text, room) + 2 * padding.y);
  const ImVec2 end{p.x + width, p.y + height};
  const bool hovered = ImGui::IsMouseHoveringRect(p, end);
  ImGui::RenderFrame(p, end, ImGui::GetColorU32(hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), true,
                     ImGui::GetStyle().FrameRounding);
  ImGui::SetCursorScreenPos({p.x + padding.x, p.y + padding.y});
  paragraph(text, ImGui::GetCursorPosX() + room);
  ImGui::SetCursorScreenPos(p);
  const bool pressed = ImGui::InvisibleButton("##shown", {width, height});
  ImGui::RenderNavHighlight({p, end}, ImGui::GetItemID());
  return pressed;
}

bool wrappedField(std::string& value, float height, TypingLimit& limit) {
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const ImGuiID id = ImGui::GetID("##typing");
  const int state = storage.GetInt(id, shown);
  if (state == shown) {
    if (drawWrapped(value, height)) storage.SetInt(id, begins);
    return false;
  }
  if (state == begins) ImGui::SetKeyboardFocusHere();
  const bool changed =
      ImGui::InputTextMultiline("##value", &value, {-FLT_MIN, height}, ImGuiInputTextFlags_CallbackCharFilter,
                                TypingLimit::filter, &limit);
  if (ImGui::IsItemActive() != (state == typed)) storage.SetInt(id, state == begins ? typed : shown);
  return changed;
}

}  // namespace

bool wrappedFieldRow(const char* name, std::string& value, std::size_t most, int lines, const char* help) {
  TypingLimit limit(value, most);
  ImGui::PushID(name);
  ImGui::TextUnformatted(tr(name));
  const float height = static_cast<float>(lines) * ImGui::GetTextLineHeight() + ImGui::GetFrameHeight();
  const bool changed = wrappedField(value, height, limit);
  highlightItem(name);
  tooltip(help);
  ImGui::PopID();
  return changed;
}

}  // namespace anamorph
