#include "panels/style.h"

namespace anamorph {
namespace {

ImVec4 rgb(int hex, float alpha = 1) {
  return {((hex >> 16) & 255) / 255.0f, ((hex >> 8) & 255) / 255.0f, (hex & 255) / 255.0f, alpha};
}

// The few colours that a theme is made of.
struct Palette {
  int window, panel, field, fieldHovered, fieldActive, border, text, accent, accentHovered;
};

Palette paletteOf(Theme theme) {
  switch (theme) {
    case Theme::light:
      return {0xF3F4F6, 0xFFFFFF, 0xE4E7EC, 0xD5DAE1, 0xC3CAD4, 0xC9CED6, 0x1B1F27, 0x1F6FBF, 0x3A8AD9};
    case Theme::projector:
      return {0xFFFFFF, 0xFFFFFF, 0xDFE5EE, 0xC6D2E2, 0xAFC0D8, 0x8A94A3, 0x000000, 0x0B5CAD, 0x2A7BCB};
    case Theme::dark:
      break;
  }
  return {0x1B1E24, 0x22262E, 0x2F353F, 0x3A424F, 0x475163, 0x373E4A, 0xE4E7EC, 0x3D7FC4, 0x5596DA};
}

void setColors(const Palette& p, ImVec4* c) {
  c[ImGuiCol_Text] = rgb(p.text);
  c[ImGuiCol_TextDisabled] = rgb(p.text, 0.55f);
  c[ImGuiCol_WindowBg] = rgb(p.window);
  c[ImGuiCol_ChildBg] = rgb(p.panel, 0);
  c[ImGuiCol_PopupBg] = rgb(p.panel);
  c[ImGuiCol_Border] = rgb(p.border);
  c[ImGuiCol_BorderShadow] = rgb(0, 0);
  c[ImGuiCol_FrameBg] = rgb(p.field);
  c[ImGuiCol_FrameBgHovered] = rgb(p.fieldHovered);
  c[ImGuiCol_FrameBgActive] = rgb(p.fieldActive);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] = rgb(p.panel);
  c[ImGuiCol_MenuBarBg] = rgb(p.panel);
  c[ImGuiCol_ScrollbarBg] = rgb(p.window, 0);
  c[ImGuiCol_ScrollbarGrab] = rgb(p.fieldHovered);
  c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = rgb(p.fieldActive);
  c[ImGuiCol_CheckMark] = c[ImGuiCol_SliderGrab] = rgb(p.accent);
  c[ImGuiCol_SliderGrab].w = 0.6f;  // the number is read through it
  c[ImGuiCol_SliderGrabActive] = rgb(p.accentHovered);
  c[ImGuiCol_Button] = rgb(p.field);
  c[ImGuiCol_ButtonHovered] = rgb(p.fieldHovered);
  c[ImGuiCol_ButtonActive] = rgb(p.fieldActive);
  c[ImGuiCol_Header] = rgb(p.accent, 0.35f);
  c[ImGuiCol_HeaderHovered] = rgb(p.accent, 0.5f);
  c[ImGuiCol_HeaderActive] = rgb(p.accent, 0.65f);
  c[ImGuiCol_Separator] = rgb(p.border);
  c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = rgb(p.accent);
  c[ImGuiCol_Tab] = rgb(p.panel);
  c[ImGuiCol_TabHovered] = rgb(p.accentHovered, 0.8f);
  c[ImGuiCol_TabActive] = rgb(p.accent, 0.8f);
  c[ImGuiCol_PlotHistogram] = rgb(p.accent);
  c[ImGuiCol_TextSelectedBg] = rgb(p.accent, 0.4f);
  c[ImGuiCol_NavHighlight] = rgb(p.accent);
  c[ImGuiCol_ModalWindowDimBg] = rgb(0, 0.35f);
}

ImVec4 on(Theme theme, const palette::ForThemes& colors) {
  return ImGui::ColorConvertU32ToFloat4(ink::of(theme == Theme::dark ? colors.dark : colors.light));
}

}  // namespace

void applyStyle(Theme theme, double scale) {
  ImGuiStyle style;
  style.WindowPadding = {12, 10};
  style.FramePadding = {7, 4};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.WindowRounding = 0;
  style.ChildRounding = style.FrameRounding = style.PopupRounding = style.GrabRounding = style.TabRounding =
      4;
  style.ScrollbarSize = 12;
  style.ScrollbarRounding = 6;
  style.WindowBorderSize = 0;
  style.FrameBorderSize = theme == Theme::projector ? 1.0f : 0.0f;
  style.WindowMenuButtonPosition = ImGuiDir_None;
  style.ScaleAllSizes(static_cast<float>(scale));
  setColors(paletteOf(theme), style.Colors);
  ImGui::GetStyle() = style;
}

double themeScale(Theme theme) {
  return theme == Theme::projector ? 1.25 : 1;
}

std::optional<Background> skyOf(Theme theme) {
  switch (theme) {
    case Theme::light:
      return Background{Color(0.32, 0.42, 0.56), Color(0.70, 0.73, 0.76)};
    case Theme::projector:
      return Background{Color(0.62, 0.70, 0.80), Color(0.85, 0.87, 0.89)};
    case Theme::dark:
      break;
  }
  return std::nullopt;
}

namespace ink {

ImVec4 good(Theme theme) {
  return on(theme, palette::good);
}
ImVec4 middling(Theme theme) {
  return on(theme, palette::middling);
}
ImVec4 bad(Theme theme) {
  return on(theme, palette::bad);
}
ImVec4 accent(Theme theme) {
  return rgb(paletteOf(theme).accentHovered);
}
ImVec4 quiet(Theme theme) {
  ImVec4 color = rgb(paletteOf(theme).text);
  color.w = 0.68f;
  return color;
}

}  // namespace ink

}  // namespace anamorph
