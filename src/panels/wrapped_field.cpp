#include "panels/wrapped_field.h"

#include <algorithm>
#include <cfloat>

#include <imgui_internal.h>
#include <imgui_stdlib.h>

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

}  // namespace

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

}  // namespace anamorph
