#include "panels/browser_view.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "base/language.h"
#include "level/limits.h"
#include "panels/browser_places.h"
#include "panels/browser_steps.h"
#include "panels/dialog.h"
#include "panels/style.h"
#include "panels/typing_limit.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

// A folder or a sheet, as high as the text.
void drawIcon(bool folder, ImVec2 at, float size) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 low{at.x + 0.08f * size, at.y + 0.2f * size}, high{at.x + 0.95f * size, at.y + 0.88f * size};
  if (folder) {
    const ImU32 color = ink::of(palette::folder);
    list->AddRectFilled(low, {low.x + 0.45f * size, high.y}, color, 0.1f * size);
    list->AddRectFilled({low.x, low.y + 0.12f * size}, high, color, 0.1f * size);
  } else {
    list->AddRect({low.x + 0.12f * size, low.y - 0.08f * size},
                  {high.x - 0.16f * size, high.y + 0.04f * size}, ImGui::GetColorU32(ImGuiCol_TextDisabled),
                  0.08f * size);
  }
}

void drawRow(FileBrowser& b, int row) {
  const FolderEntry entry =
      b.listing.entries[static_cast<std::size_t>(b.shown[static_cast<std::size_t>(row)])];
  ImGui::PushID(row);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float size = ImGui::GetTextLineHeight();
  if (ImGui::Selectable("##row", row == b.selected, ImGuiSelectableFlags_AllowDoubleClick)) {
    selectRow(b, row);
    b.bringIntoView = false;  // it is under the mouse
    if (ImGui::IsMouseDoubleClicked(0)) acceptChoice(b);
  }
  drawIcon(entry.isFolder, at, size);
  ImGui::GetWindowDrawList()->AddText({at.x + 1.4f * size, at.y}, ImGui::GetColorU32(ImGuiCol_Text),
                                      entry.name.c_str());
  ImGui::PopID();
}

struct Answers {
  const char* yes;
  const char* no;
};

Answers answersOf(const FileBrowser& b) {
  if (!b.replace.empty()) return {"Replace", "Back"};
  if (b.namingFolder) return {"Make", "Back"};
  return {b.purpose.button, "Cancel"};
}

// Whether the check boxes and the buttons have one line together.
bool footerIsOneLine(const FileBrowser& b) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float boxes = 2 * (ImGui::GetFrameHeight() + style.ItemInnerSpacing.x + style.ItemSpacing.x) +
                      ImGui::CalcTextSize(tr("Hidden")).x + ImGui::CalcTextSize(tr("All files")).x;
  const auto [yes, no] = answersOf(b);
  return !b.replace.empty() || boxes + dialogButtonsWidth({yes, no}) <= ImGui::GetContentRegionAvail().x;
}

// Returns how many rows are in sight.
int drawList(FileBrowser& b, const ImVec2& size) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
  ImGui::BeginChild("files", size, true);
  const float height = ImGui::GetTextLineHeightWithSpacing(), room = ImGui::GetContentRegionAvail().y;
  if (b.bringIntoView && b.selected >= 0) {
    const float top = height * static_cast<float>(b.selected), scroll = ImGui::GetScrollY();
    if (top < scroll) ImGui::SetScrollY(top);
    if (top + height > scroll + room) ImGui::SetScrollY(top + height - room);
  }
  b.bringIntoView = false;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(b.shown.size()), height);
  while (clipper.Step()) {
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      if (row < static_cast<int>(b.shown.size()))
        drawRow(b, row);  // a double click may have changed the list
    }
  }
  clipper.End();
  if (b.shown.empty())
    ImGui::TextDisabled("%s", tr(b.text.empty() ? "Nothing to choose here" : "Nothing like this here"));
  ImGui::EndChild();
  ImGui::PopStyleColor();
  return std::max(1, static_cast<int>(room / height) - 1);
}

// Letters that come before the field has the keyboard, which takes it two frames, would be lost.
bool takeEarlyLetters(FileBrowser& b) {
  ImGuiIO& io = ImGui::GetIO();
  if (ImGui::GetActiveID() == ImGui::GetID("##text") || io.InputQueueCharacters.empty()) return false;
  if (std::exchange(b.proposed, false)) b.text.clear();
  TypingLimit limit(b.text, limits::mostPathBytes);
  for (const ImWchar letter : io.InputQueueCharacters) {
    if (letter < 32 || letter == 127 || !limit.takes(letter)) continue;
    char bytes[5] = {};
    ImTextCharToUtf8(bytes, letter);
    b.text += bytes;
  }
  io.InputQueueCharacters.resize(0);
  b.caretToEnd = b.takeFocus = true;
  return true;
}

struct Typing {
  FileBrowser& browser;
  TypingLimit limit;
};

int onTyping(ImGuiInputTextCallbackData* data) {
  auto& [browser, limit] = *static_cast<Typing*>(data->UserData);
  if (data->EventFlag == ImGuiInputTextFlags_CallbackCharFilter) return limit.takes(data->EventChar) ? 0 : 1;
  if (std::exchange(browser.caretToEnd, false)) {
    data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
  }
  return 0;
}

void drawField(FileBrowser& b) {
  const char* newFolder = "New folder";
  const ImGuiStyle& style = ImGui::GetStyle();
  const float button = ImGui::CalcTextSize(tr(newFolder)).x + 2 * style.FramePadding.x + style.ItemSpacing.x;
  const bool here =
      ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows | ImGuiFocusedFlags_NoPopupHierarchy);
  const bool idle = here && !ImGui::IsAnyItemActive() && !ImGui::IsAnyMouseDown();
  if (b.takeFocus || idle) ImGui::SetKeyboardFocusHere();
  b.takeFocus = false;
  const bool makesFolders = b.purpose.saves && !b.namingFolder;
  ImGui::SetNextItemWidth(makesFolders ? -button : -FLT_MIN);
  ImGui::PushID(b.fieldNumber);
  const char* hint = b.namingFolder    ? "Name of the new folder"
                     : b.purpose.saves ? "Name of the file"
                                       : "Type to filter, or a path";
  const bool early = takeEarlyLetters(b);
  Typing typing{b, TypingLimit(b.text, limits::mostPathBytes)};
  constexpr int events = ImGuiInputTextFlags_CallbackAlways | ImGuiInputTextFlags_CallbackCharFilter;
  const bool typed = ImGui::InputTextWithHint("##text", tr(hint), &b.text, events, onTyping, &typing);
  if (typed || early) {
    b.problem.clear();
    b.proposed = false;
    if (b.purpose.saves) b.selected = -1;
    if (!b.namingFolder) enterTypedFolder(b);
  }
  ImGui::PopID();
  if (!makesFolders) return;
  ImGui::SameLine();
  if (ImGui::Button(tr(newFolder))) {
    b.textBefore = b.text;
    b.namingFolder = true;
    setBrowserText(b, "");
  }
}

void drawFooter(FileBrowser& b, const Look& look) {
  if (!b.problem.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, ink::bad(look.theme));
    paragraph(b.problem);
    ImGui::PopStyleColor();
  }
  const auto [yes, no] = answersOf(b);
  if (!b.replace.empty()) {
    ImGui::AlignTextToFramePadding();
    paragraph(trFormat("{} exists. Replace it?", b.replace.filename().string()));
  } else {
    const bool oneLine = footerIsOneLine(b);
    drawField(b);
    ImGui::Checkbox(tr("Hidden"), &b.showHidden);
    tooltip("Names that begin with a dot.");
    ImGui::SameLine();
    ImGui::Checkbox(tr("All files"), &b.showAll);
    tooltip("Files of other kinds, too.");
    if (oneLine) ImGui::SameLine();
  }
  const int pressed = dialogButtons({yes, no});
  if (pressed == 0) acceptChoice(b);
  if (pressed == 1) leaveStep(b);
}

float footerHeight(const FileBrowser& b) {
  float height = (footerIsOneLine(b) ? 2.0f : 3.0f) * ImGui::GetFrameHeightWithSpacing();
  if (!b.problem.empty()) {
    const float width = ImGui::GetContentRegionAvail().x;
    height += paragraphHeight(b.problem, width) + ImGui::GetStyle().ItemSpacing.y;
  }
  return height;
}

}  // namespace

void drawFileBrowser(FileBrowser& b, const DialogKeys& typed, const Look& look) {
  const bool fieldWasEmpty = b.text.empty();
  if (!beginDialog(look, b.purpose.title, 760, 520)) return;
  const float below = footerHeight(b);
  ImGui::BeginDisabled(!b.replace.empty());  // the question is about what is shown
  if (const auto folder = drawPathRow(b, look)) enterFolder(b, *folder);
  if (placesAreBeside(look)) {
    if (const auto folder = drawPlaces(b, look, below)) enterFolder(b, *folder);
    ImGui::SameLine();
  }
  chooseShown(b);
  const int rows = drawList(b, {0, -below});
  ImGui::EndDisabled();
  drawFooter(b, look);
  if (b.open) handleBrowserKeys(b, typed, fieldWasEmpty, rows);
  chooseShown(b);
  if (!b.open) ImGui::CloseCurrentPopup();
  endDialog();
}

}  // namespace anamorph
