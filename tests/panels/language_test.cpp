// Whether everything that people read in the window has a translation, by what is drawn in the end. What stands in
// the source is looked at in dutch_texts_test.cpp.

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "base/language.h"
#include "level/json.h"
#include "level/mirror_kind.h"
#include "optics/shape_table.h"
#include "panels/dialogs.h"
#include "panels/dutch.h"
#include "panels/export_entries.h"
#include "panels/file_browser.h"
#include "panels_fixture.h"
#include "pipeline/stages.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using namespace anamorph::testing;

TEST(DutchTexts, HaveTheNamesThatAreMadeElsewhere) {
  const std::vector<std::string> keys = dutchKeys();
  const std::set<std::string> known(keys.begin(), keys.end());
  std::vector<std::string> names;
  for (int i = 0; i < matchGradeCount; ++i) names.emplace_back(matchGradeName(static_cast<MatchGrade>(i)));
  for (int i = 0; i < pathStatusCount; ++i) names.emplace_back(pathStatusWords(static_cast<PathStatus>(i)));
  for (const ShapeType& type : shapeTypes()) names.emplace_back(type.name);
  names.emplace_back(surfaceName({OpticKind::mirror, {}}));
  names.emplace_back(surfaceName({OpticKind::canvas, {}}));
  for (const std::string& name : names) EXPECT_EQ(known.count(name), 1u) << name;
}

// A language that is English in guillemets: what is drawn outside of them was not translated.
class DrawnText : public PanelsTest {
 protected:
  DrawnText() {
    for (const std::string& key : dutchKeys()) table_[key] = "«" + key + "»";
    setLanguage(&table_);
    ImGui::GetIO().DisplaySize = {3000, 4000};  // so that nothing is scrolled away or cut off
    ui.preferences.leftWidth = 600;
    ui.preferences.rightWidth = 900;
  }
  ~DrawnText() override { setLanguage(nullptr); }

  // Draws a frame with everything unfolded and looks at its words.
  void look(const std::string& where) {
    frame();
    unfold();
    frame();
    const std::string drawn = drawnText();
    EXPECT_NE(drawn.find("«"), std::string::npos) << where;
    for (const std::string& word : englishWordsIn(drawn)) ADD_FAILURE() << where << ": \"" << word << "\"";
    seen_ += drawn;
  }

  bool hasSeen(const std::string& english) const {
    return seen_.find("«" + english + "»") != std::string::npos;
  }

 private:
  // The sections that are folded in the beginning.
  void unfold() const {
    for (ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
      if (std::string(window->Name).find("properties/rows") != 0) continue;
      const ImGuiID rows = window->ID;
      for (const char* section :
           {"Ray tracer", "Look", "Material", "Surroundings", "Title and description"}) {
        window->StateStorage.SetInt(ImHashStr(section, 0, rows), 1);
        window->StateStorage.SetInt(ImHashStr((std::string("###") + section).c_str(), 0, rows), 1);
      }
    }
  }

  // All letters of the frame, found by their place in the font's picture; a line break where the pen jumps.
  static std::string drawnText() {
    const ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
    std::map<std::pair<float, float>, const ImFontGlyph*> letters;
    for (const ImFontGlyph& glyph : font.Glyphs) {
      if (glyph.Visible != 0) letters[{glyph.U0, glyph.V0}] = &glyph;
    }
    std::string text;
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int i = 0; i < data.CmdListsCount; ++i) {
      const ImVector<ImDrawVert>& v = data.CmdLists[i]->VtxBuffer;
      ImVec2 pen{-1000, -1000};
      for (int k = 0; k + 3 < v.Size; ++k) {
        const auto found = letters.find({v[k].uv.x, v[k].uv.y});
        if (found == letters.end() || !(v[k + 2].uv.x > v[k].uv.x)) continue;
        const ImFontGlyph& glyph = *found->second;
        const float scale = (v[k + 2].pos.y - v[k].pos.y) / (glyph.Y1 - glyph.Y0);
        const float x = v[k].pos.x - scale * glyph.X0, y = v[k].pos.y - scale * glyph.Y0;
        const float gap = (x - pen.x) / scale, drop = std::abs(y - pen.y) / scale;
        if (drop > 1 || gap < -2 || gap > 3 * glyph.AdvanceX) {
          text += '\n';
        } else if (gap > 2) {
          text += ' ';
        }
        char bytes[5] = {};
        ImTextCharToUtf8(bytes, glyph.Codepoint);
        text += bytes;
        pen = {x + scale * glyph.AdvanceX, y};
        k += 3;
      }
    }
    return text;
  }

  std::vector<std::string> englishWordsIn(const std::string& drawn) const {
    std::vector<std::string> words;
    std::string word;
    int depth = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      const bool opens = drawn.compare(i, 2, "«") == 0, closes = drawn.compare(i, 2, "»") == 0;
      if (std::isspace(static_cast<unsigned char>(drawn[i])) != 0 || opens || closes) {
        if (hasWord(word) && !isNoText(word)) words.push_back(word);
        word.clear();
      } else if (depth == 0) {
        word += drawn[i];
      }
      depth += opens - closes;
      if (opens || closes) ++i;
    }
    return words;
  }

  // Units, keys, names of files and of languages.
  bool isNoText(const std::string& word) const {
    static const std::set<std::string> others{"px",    "mm",   "ms",   "Esc",  "Tab",  "Home",
                                              "Space", "Page", "Down", "Left", "Right"};
    if (others.count(word) != 0) return true;
    for (const fs::path& part : ui.browser.folder) {
      if (part == word) return true;
    }
    if (word.starts_with("Ctrl+") || word.starts_with("Shift+") || word.starts_with("Alt+")) return true;
    return word.find('.') != std::string::npos || word.find('/') != std::string::npos ||
           std::any_of(ui.languages.begin(), ui.languages.end(),
                       [&](const LanguageChoice& language) { return language.name == word; });
  }

  TextTable table_;
  std::string seen_;
};

TEST_F(DrawnText, OfTheLevelsIsTranslated) {
  for (const LevelEntry& entry : listLevels(ANAMORPH_LEVELS)) {
    open(entry.name);
    look(entry.name);
  }
  EXPECT_TRUE(hasSeen("Levels"));
}

TEST_F(DrawnText, OfThePropertiesIsTranslated) {
  open("2-cylinder");
  ui.languages = {{"en", "English"}, {"nl", "Nederlands"}};
  editor.rays.source = RaySource::vertices;
  editor.rays.animate = true;
  editor.rays.lightRays = true;
  editor.preview.expanded = false;
  Level own = editor.session.level();
  own.text = LevelText{
      "«its author's words»", "«its author's words»", own.text->lesson, {}};  // which are edited as they are
  editor.session.edit(std::move(own));
  for (int tab = 0; tab < 7; ++tab) {
    openTab(ui.tabs, editor.selection, static_cast<PropertyTab>(tab));
    if (tab == static_cast<int>(PropertyTab::sculpture)) editor.point = PickedPoint{};
    look("tab " + std::to_string(tab));
  }
  EXPECT_TRUE(hasSeen("Depth scale k"));
  EXPECT_TRUE(hasSeen("Description"));
  EXPECT_TRUE(hasSeen("Shininess")) << "what is folded is drawn, too";
  editor.selection = {Part::light, 0};
  look("a light");
  EXPECT_TRUE(hasSeen("Intensity"));
  for (std::size_t kind = 0; kind < shapeTypes().size(); ++kind) {
    Level level = editor.session.level();
    level.optic.shape() = mirrorOfKind(kind, level.optic.shape(), level.camera.eye);
    editor.session.edit(std::move(level));
    editor.updater.finish(editor.session, {});
    openTab(ui.tabs, editor.selection, PropertyTab::mirror);
    look("mirror " + std::to_string(kind));
  }
}

TEST_F(DrawnText, OfProblemsIsTranslated) {
  for (const char* name : {"1-plane", "2-cylinder", "3-sphere"}) {
    open(name);
    const Level before = editor.session.level();
    Level level = before;
    level.camera.eye = middleOf(level.optic.shape());
    editor.session.edit(level);
    editor.updater.finish(editor.session, {});
    openTab(ui.tabs, editor.selection, PropertyTab::eye);
    look(std::string(name) + ", the eye in the mirror");
    EXPECT_TRUE(hasSeen("There is no sculpture"));
    level = before;
    level.original.placement.position += Vector(0, 0, 40);
    editor.session.edit(level);
    editor.updater.finish(editor.session, {});
    openTab(ui.tabs, editor.selection, PropertyTab::original);
    look(std::string(name) + ", the original far away");
    level = before;
    level.original.placement.scale *= 2.5;
    editor.session.edit(level);
    editor.updater.finish(editor.session, {});
    openTab(ui.tabs, editor.selection, PropertyTab::sculpture);
    look(std::string(name) + ", the original too large");
  }
}

TEST_F(DrawnText, OfTheWindowsIsTranslated) {
  open("2-cylinder");
  ui.helpOpen = true;
  frame();
  ImGui::SetWindowSize("###help", {900, 3000});
  look("help");
  EXPECT_TRUE(hasSeen("Words"));
  ui.helpOpen = false;
  ui.exporting.open = true;
  for (std::size_t kind = 0; kind < exportEntries().size(); ++kind) {
    ui.exporting.kind = static_cast<int>(kind);
    look(std::string("export ") + exportEntries()[kind].name);
  }
  EXPECT_TRUE(hasSeen("Times as large")) << "the screenshot's";
  ui.exporting.open = false;
  ui.render.open = true;
  look("render");
  ui.render.running = true;
  look("rendering");
  ui.render.open = false;
  ui.progress.open = true;
  look("progress");
  ui.progress.open = false;
  for (ui.tour.card = 0; ui.tour.card < tourCards; ++ui.tour.card)
    look("tour " + std::to_string(ui.tour.card));
  ui.tour.card = -1;
  ui.presenting = true;
  look("presenting");
}

TEST_F(DrawnText, OfTheDialogsIsTranslated) {
  open("2-cylinder");
  const fs::path folder = fs::path(ANAMORPH_TEST_DATA) / "levels";
  std::vector<FilePurpose> purposes{FilePurpose::openLevel, FilePurpose::saveLevel, FilePurpose::openMesh};
  for (const ExportEntry& entry : exportEntries()) purposes.push_back(entry.purpose);
  for (const FilePurpose& purpose : purposes) {
    ui.browser.root = folder;
    browseFiles(ui.browser, purpose, folder / "file.json");
    frames(2);
    look(std::string("browser: ") + purpose.title);
  }
  ui.browser = {};
  frames(2);
  ui.unsaved = UnsavedQuestion{};
  look("unsaved");
  ui.unsaved.reset();
  frames(2);
  for (const auto answer : {FinishQuestion::Answer::none, FinishQuestion::Answer::wait}) {
    ui.finish = FinishQuestion{answer};
    look("finish");
  }
  ui.finish.reset();
  frames(2);
  ui.recovery.entries = {RecoveryEntry{}};
  look("recovery");
  ui.recovery.entries.front().fileIsNewer = true;
  look("recovery, older than the file");
}

// All menus, opened by the mouse.
TEST_F(DrawnText, OfTheMenusIsTranslated) {
  open("2-cylinder");
  frames(2);
  const float y = ui.layout.menu.y + ui.layout.menu.height / 2;
  click(ui.layout.menu.x + 20, y);
  for (float x = 20; x < 420; x += 20) {
    moveMouse(x, y);
    frames(2);
    look("menus at " + std::to_string(static_cast<int>(x)));
  }
  for (const char* item : {"Quit", "Own axes", "Full screen", "Next level", "Show me around"}) {
    EXPECT_TRUE(hasSeen(item)) << item;
  }
}

}  // namespace
}  // namespace anamorph
