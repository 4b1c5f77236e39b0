// The panels by keys alone.

#include "panels/key_focus.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "panels_fixture.h"

namespace anamorph::testing {
namespace {

class KeyFocus : public PanelsTest {
 protected:
  KeyFocus() {
    // As the window's back end does it.
    ImGuiIO& io = ImGui::GetIO();
    const std::pair<ImGuiKey, int> map[] = {
        {ImGuiKey_Tab, keys::tab},     {ImGuiKey_LeftArrow, keys::left}, {ImGuiKey_RightArrow, keys::right},
        {ImGuiKey_UpArrow, keys::up},  {ImGuiKey_DownArrow, keys::down}, {ImGuiKey_Enter, keys::enter},
        {ImGuiKey_Space, keys::space}, {ImGuiKey_Escape, keys::escape}};
    for (const auto& [name, code] : map) io.KeyMap[name] = code;
    open("2-cylinder");
    frames(3);
  }

  // As Gui::key and the window's back end.
  void key(int code, int modifiers = 0) {
    ImGui::GetIO().KeysDown[code] = true;
    if (!ImGui::GetIO().WantTextInput) handleKey(code, modifiers, editor, ui);
    frames(2);
    ImGui::GetIO().KeysDown[code] = false;
    frames(2);
  }
  void type(const std::string& text) {
    for (const char c : text) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
    frames(2);
  }
  static std::string focused() {
    const ImGuiWindow* window = GImGui->NavWindow;
    return window ? window->RootWindow->Name : "";
  }
};

TEST_F(KeyFocus, GoesAroundAllPanels) {
  for (const char* name : {"levels", "lesson", "properties", "preview"}) {
    key(keys::f6);
    EXPECT_EQ(ui.keyFocus.window, name);
    EXPECT_EQ(focused(), name);
    EXPECT_NE(GImGui->NavId, 0u) << "its first control is marked at once";
    EXPECT_FALSE(GImGui->NavDisableHighlight);
  }
  key(keys::f6);
  EXPECT_EQ(ui.keyFocus.window, "") << "the 3D view again";
  EXPECT_TRUE(GImGui->NavDisableHighlight) << "and no control is marked any more";
  key(keys::f6, keys::shift);
  EXPECT_EQ(ui.keyFocus.window, "preview");
  perform(Action::help, editor, ui);
  frames(2);
  key(keys::f6);
  EXPECT_EQ(ui.keyFocus.window, "###help");
  perform(Action::help, editor, ui);
  frames(2);
  EXPECT_EQ(ui.keyFocus.window, "") << "it was closed";
}

TEST_F(KeyFocus, RestsWhileADialogAsks) {
  for (int i = 0; i < 3; ++i) key(keys::f6);
  ui.notice = Notice{"This cannot be used here", "text"};
  frames(3);
  EXPECT_EQ(ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard, 0);
  EXPECT_TRUE(GImGui->NavDisableHighlight);
  ui.notice.reset();
  frames(3);
  EXPECT_EQ(focused(), "properties");
  EXPECT_FALSE(GImGui->NavDisableHighlight);
}

TEST_F(KeyFocus, ShortcutsSleepUntilEsc) {
  key(keys::f6);
  const GizmoMode before = editor.gizmoMode;
  ASSERT_NE(before, GizmoMode::rotate);
  key('E');
  EXPECT_EQ(editor.gizmoMode, before);
  EXPECT_TRUE(handleKey('Z', keys::control, editor, ui)) << "those with Ctrl go on";
  key(keys::escape);
  EXPECT_EQ(ui.keyFocus.window, "");
  key('E');
  EXPECT_EQ(editor.gizmoMode, GizmoMode::rotate);
  key(keys::f6);
  click(ui.layout.view.x + 40, ui.layout.view.y + 60);
  EXPECT_EQ(ui.keyFocus.window, "") << "a click is the mouse's";
}

TEST_F(KeyFocus, EveryNumberOfAPropertyCanBeTyped) {
  const Level before = editor.session.level();
  for (int i = 0; i < 3; ++i) key(keys::f6);
  ASSERT_EQ(ui.keyFocus.window, "properties");
  int changed = 0;
  for (int row = 0; row < 24; ++row) {
    key(keys::down);
    key(keys::enter);
    if (!ImGui::GetIO().WantTextInput) continue;  // no number
    type("7.5");
    key(keys::enter);
    if (editor.session.canUndo()) {
      ++changed;
      EXPECT_EQ(steps(), 1) << "a typed number is one step";
      editor.session.undo();
      frames(2);
    }
  }
  EXPECT_GE(changed, 3);
  EXPECT_EQ(editor.session.level(), before);
}

TEST_F(KeyFocus, AButtonIsPressedBySpace) {
  key(keys::f6);
  key(keys::f6);
  ASSERT_EQ(ui.keyFocus.window, "lesson");
  const std::size_t step = editor.lesson.step;
  for (int i = 0; i < 12 && editor.lesson.step == step; ++i) {
    for (const int way : {keys::down, keys::right}) {
      key(way);
      if (editor.lesson.step == step) key(keys::space);
    }
  }
  EXPECT_NE(editor.lesson.step, step) << "Skip was reached";
}

}  // namespace
}  // namespace anamorph::testing
