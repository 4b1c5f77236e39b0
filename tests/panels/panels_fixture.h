// The panels in a Dear ImGui without window and renderer: frames are laid out and thrown away, mouse and keys
// are set by the test.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include <gtest/gtest.h>
#include <imgui.h>

#include "edit/advance.h"
#include "panels/actions.h"
#include "panels/key_input.h"
#include "panels/panels.h"
#include "panels/style.h"
#include "panels/view_panel.h"

namespace anamorph::testing {

class PanelsTest : public ::testing::Test {
 protected:
  PanelsTest() : context_(ImGui::CreateContext()) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.DisplaySize = {1280, 800};
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    moveMouse(-1, -1);
    ui.levels = listLevels(ANAMORPH_LEVELS);
    setLook(Theme::dark, 1);
  }
  ~PanelsTest() override { ImGui::DestroyContext(context_); }

  void setLook(Theme theme, double scale) {
    ui.theme = ui.preferences.theme = theme;
    ui.scale = scale;
    applyStyle(theme, scale);
  }

  void open(const std::string& name) {
    openLevel(editor, std::filesystem::path(ANAMORPH_LEVELS) / (name + ".json"));
    editor.updater.finish(editor.session, {});
  }

  // As Gui::frame, without OpenGL.
  void frame(double seconds = 1.0 / 60) {
    ImGui::GetIO().DeltaTime = static_cast<float>(seconds);
    ImGui::NewFrame();
    handleInput(editor, ui);
    advance(editor, seconds);
    drawPanels(editor, ui);
    ImGui::Render();
    checkVertices();
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) frame();
  }

  static void moveMouse(float x, float y) { ImGui::GetIO().MousePos = {x, y}; }
  static void press(bool down) { ImGui::GetIO().MouseDown[0] = down; }
  void click(float x, float y) {
    moveMouse(x, y);
    frames(2);
    press(true);
    frame();
    press(false);
    frames(2);
  }
  void letGo() {
    press(false);
    frames(2);
    moveMouse(-1, -1);
    frames(2);
  }

  // Drags from some place of the properties' middle column so that `wanted` is true of the level, and keeps
  // the button down. Returns where the drag began.
  std::optional<ImVec2> dragRow(const std::function<bool(const Level& before, const Level& now)>& wanted,
                                float distance = 20) {
    const Rect& rect = ui.layout.properties;
    const Level before = editor.session.level();
    for (float y = rect.y + 70; y < rect.y + rect.height; y += 5) {
      const ImVec2 at{rect.x + 0.46f * rect.width, y};
      moveMouse(at.x, at.y);
      frames(2);
      press(true);
      frame();
      moveMouse(at.x + distance, at.y);
      frame();
      if (wanted(before, editor.session.level())) return at;
      moveMouse(-1, -1);  // away from what reacts to being let go
      frame();
      letGo();
      while (editor.session.canUndo()) editor.session.undo();
      frame();
    }
    return std::nullopt;
  }

  // Where a handle of the gizmo can be taken, in the window.
  std::optional<ImVec2> gripOf(GizmoHandle handle) const {
    const anamorph::Gizmo gizmo = currentGizmo(editor, ui).gizmo;
    for (const GizmoShape& shape : gizmo.shapes) {
      if (shape.handle != handle || shape.points.empty()) continue;
      Pixel middle(0);
      for (const Pixel& p : shape.points) middle += p / double(shape.points.size());
      if (pickHandle(gizmo, middle) == handle)
        return ImVec2{ui.layout.view.x + static_cast<float>(middle.x),
                      ui.layout.view.y + static_cast<float>(middle.y)};
    }
    return std::nullopt;
  }

  // Steps to undo, counted by undoing and redoing.
  int steps() {
    int count = 0;
    for (; editor.session.canUndo(); ++count) editor.session.undo();
    for (int i = 0; i < count; ++i) editor.session.redo();
    return count;
  }

  Editor editor{{}, 2};
  UiState ui;

 private:
  static void checkVertices() {
    const ImDrawData* data = ImGui::GetDrawData();
    ASSERT_TRUE(data && data->Valid);
    for (int i = 0; i < data->CmdListsCount; ++i) {
      for (const ImDrawVert& v : data->CmdLists[i]->VtxBuffer) {
        ASSERT_TRUE(std::isfinite(v.pos.x) && std::isfinite(v.pos.y)) << "a vertex of the panels";
      }
    }
  }

  ImGuiContext* context_;
};

}  // namespace anamorph::testing
