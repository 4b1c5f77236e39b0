// Texts as long as a level may have them, everywhere they are shown: Dear ImGui alone would end the program, and measure
// all of them in every frame.

#include "panels/long_text.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "level/json.h"
#include "level/level_json.h"
#include "level/limits.h"
#include "panels/file_browser.h"
#include "panels/typing_limit.h"
#include "panels_fixture.h"
#include "source_text.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;

class LongTextTest : public PanelsTest {
 protected:
  LongTextTest() {
    ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;  // as OpenGL has it
  }

  static std::string repeated(const std::string& piece) {
    std::string text;
    while (text.size() + piece.size() <= limits::mostTextBytes) text += piece;
    return text;
  }

  // A level all of whose words are this one.
  Level wordy(const std::string& text, bool withLesson) {
    open("1-plane");
    Level level = editor.session.level();
    LevelText words = *level.text;
    words.title = words.description = text;
    const std::string string = quoteJson(text);
    words.lesson = !withLesson ? ""
                               : R"({"id": "l", "badge": {"title": )" + string + R"(, "text": )" + string +
                                     R"(}, "steps": [{"id": "s", "title": )" + string + R"(, "why": )" +
                                     string + R"(, "do": )" + string + R"(, "notice": )" + string + "}]}";
    level.text = std::move(words);
    return level;
  }

  void drawEverywhere(const Level& level) {
    editor.session.edit(level);
    for (LevelEntry& entry : ui.levels) {
      entry.title = entry.problem = level.text->title;
      entry.lesson = parseLesson(level.text->lesson, "l");
    }
    editor.status.say(level.text->title);
    ui.progress.open = true;
    ui.notice = Notice{"The level could not be opened", level.text->title};
    frames(3);
    ui.notice.reset();
    ui.unsaved = UnsavedQuestion{};
    frames(3);
    ui.unsaved.reset();
    ui.recovery.entries = {
        RecoveryEntry{"/a/" + level.text->title, level.text->title, "now", level.text->title}};
    frames(3);
    ui.recovery.entries.clear();
    browseFiles(ui.browser, FilePurpose::openLevel, "");
    frames(3);
    ui.browser.text = ui.browser.problem = level.text->title;
    frames(3);
    ui.browser = {};
    editor.lesson.done = editor.lesson.doneNow = true;
    frames(2);
    ui.presenting = true;
    frames(3);
    ui.presenting = false;
    for (const float y : {60.0f, 100.0f, 790.0f}) {  // tooltips
      moveMouse(100, y);
      for (int i = 0; i < 4; ++i) frame(0.4);
    }
    moveMouse(-1, -1);
    openTab(ui.tabs, editor.selection, PropertyTab::view);
    frames(2);
  }
};

TEST_F(LongTextTest, OfALevelIsDrawnEverywhere) {
  for (const std::string& piece :
       {std::string("word "), std::string("x"), std::string(" %"), std::string("\n"), std::string("\u00a0"),
        std::string("\u200b"), std::string("日本"), std::string("\u0301")}) {
    for (const bool withLesson : {false, true}) {
      SCOPED_TRACE("\"" + piece + "\"");
      drawEverywhere(wordy(repeated(piece), withLesson));
    }
  }
}

TEST_F(LongTextTest, IsMeasuredOnceAndDrawnWhereItIsSeen) {
  for (const bool withLesson : {false, true}) {
    editor.session.edit(wordy(repeated("longer %"), withLesson));
    frames(3);  // the scroll bar takes some of the width
    const std::size_t measured = ui.longTexts.measured();
    EXPECT_GT(measured, 1000u);
    const std::size_t drawn = ui.longTexts.drawn();
    frames(10);
    EXPECT_EQ(ui.longTexts.measured(), measured);
    EXPECT_LT(ui.longTexts.drawn() - drawn, 10u * 60) << "no more lines than have room";
  }
}

TEST_F(LongTextTest, CanBeScrolledToItsEnd) {
  editor.session.edit(wordy(repeated("line\n"), false));
  frames(3);
  const std::size_t lines = limits::mostTextBytes / 5;
  EXPECT_GT(ImGui::FindWindowByName("lesson")->ScrollMax.y,
            static_cast<float>(lines - 100) * ImGui::GetTextLineHeight());
}

TEST_F(LongTextTest, IsTypedAndPastedUpToItsLimit) {
  TypingLimit limit(std::string(limits::mostTitleBytes - 3, 'x'), limits::mostTitleBytes);
  EXPECT_FALSE(limit.takes(0x1F600)) << "four bytes";
  EXPECT_TRUE(limit.takes(0xE4));
  EXPECT_FALSE(limit.takes(0xE4));
  EXPECT_TRUE(limit.takes('x'));
  EXPECT_FALSE(limit.takes('x'));
  EXPECT_FALSE(TypingLimit(std::string(2 * limits::mostTitleBytes, 'x'), limits::mostTitleBytes).takes('x'));
}

TEST(WrappedText, IsDrawnInOnePlaceThatLimitsIt) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(sourceFolder / "src")) {
    const std::filesystem::path& file = entry.path();
    if (!entry.is_regular_file() || file.filename() == "widgets.cpp") continue;
    const std::string code = textOf(file);
    for (const char* call : {"PushTextWrapPos", "TextWrapped"}) {
      EXPECT_EQ(code.find(call), std::string::npos) << file << ": paragraph() limits its length";
    }
  }
}

}  // namespace
}  // namespace anamorph
