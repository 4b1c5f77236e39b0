#include "panels/file_browser.h"

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "cli/program.h"
#include "exports/export_formats.h"
#include "panels/dialogs.h"
#include "panels/file_flow.h"
#include "panels_fixture.h"

namespace anamorph::testing {
namespace {

namespace fs = std::filesystem;

const FilePurpose saveMesh = FilePurpose::toSave(formatOf(ExportKind::sculpture));

class Browser : public PanelsTest {
 protected:
  Browser() {
    for (const char* name :
         {"level-2.json", "level-10.json", "Level-1.json", "cube.obj", "notes.txt", ".secret.json"})
      writeText(folder_ / name, "{}");
    fs::create_directories(folder_ / "works/deep");
    fs::create_directories(folder_ / "Album");
    fs::create_directories(folder_ / ".config");
    writeText(folder_ / "works/mine.json", "{}");
    open("1-plane");
  }

  void browse(const FilePurpose& purpose, const std::string& start = "") {
    browseFiles(ui.browser, purpose, start.empty() ? folder_ / "" : start);
    frames(3);
  }
  void type(const std::string& text) {
    for (const char c : text) {
      ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
      frame();
    }
    frame();
  }
  void key(int code, bool repeated = false) {
    handleKey(code, 0, editor, ui, repeated);
    frames(2);
  }
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const int i : ui.browser.shown)
      result.push_back(ui.browser.listing.entries[static_cast<std::size_t>(i)].name);
    return result;
  }
  std::string selected() const {
    const int row = ui.browser.selected;
    return row < 0 ? "" : names().at(static_cast<std::size_t>(row));
  }
  std::string at(const std::string& name) const { return folder_ / name; }

  TemporaryFolder folder_;
};

using Names = std::vector<std::string>;

TEST_F(Browser, ShowsFoldersAndFilesOfItsKindInOrder) {
  browse(FilePurpose::openLevel);
  EXPECT_EQ(names(), (Names{"Album", "works", "Level-1.json", "level-2.json", "level-10.json"}));
  browse(FilePurpose::openMesh);
  EXPECT_EQ(names(), (Names{"Album", "works", "cube.obj"}));
  ui.browser.showHidden = true;
  ui.browser.showAll = true;
  frames(2);
  EXPECT_EQ(names().size(), 9u);
}

TEST_F(Browser, IsUsedByKeysAlone) {
  browse(FilePurpose::openLevel);
  EXPECT_TRUE(isDialogOpen(ui));
  key(keys::down);
  EXPECT_EQ(selected(), "Album");
  key(keys::down);
  EXPECT_EQ(selected(), "works");
  key(keys::enter);
  EXPECT_EQ(ui.browser.folder, at("works"));
  EXPECT_EQ(names(), (Names{"deep", "mine.json"}));
  key(keys::backspace);
  EXPECT_EQ(ui.browser.folder, fs::path(at("")).parent_path());
  EXPECT_EQ(selected(), "works") << "where it came from";
  key(keys::pageDown);
  key(keys::pageDown);
  EXPECT_EQ(selected(), "level-10.json") << "ends at the last";
  key(keys::up);
  EXPECT_EQ(selected(), "level-2.json");
  key(keys::enter);
  EXPECT_FALSE(isDialogOpen(ui));
  EXPECT_EQ(takeChosenFile(ui.browser, FilePurpose::saveImage), std::nullopt) << "it was not for this";
  EXPECT_EQ(takeChosenFile(ui.browser, FilePurpose::openLevel), fs::path(at("level-2.json")));
}

TEST_F(Browser, GivesTheFileOnceToWhoAsked) {
  browse(FilePurpose::openMesh);
  ui.browser.purpose = saveMesh;
  browse(FilePurpose::saveImage);
  type("picture");
  key(keys::enter);
  EXPECT_FALSE(ui.browser.open);
  EXPECT_EQ(takeChosenFile(ui.browser, FilePurpose::openMesh), std::nullopt);
  EXPECT_EQ(takeChosenFile(ui.browser, FilePurpose::saveImage), fs::path(at("picture.png")));
  EXPECT_EQ(takeChosenFile(ui.browser, FilePurpose::saveImage), std::nullopt);
  EXPECT_EQ(ui.browser.recentFolders.front(), fs::path(at("")).parent_path());
}

// In place of the name that is proposed.
TEST_F(Browser, AnotherKindOfFileIsRefusedAsOnTheCommandLine) {
  const std::pair<FilePurpose, const char*> cases[] = {
      {saveMesh, "x.3mf: expected an output file that ends in .obj, .stl or .ply"},
      {FilePurpose::saveImage, "x.jpg: expected an output file that ends in .png"},
      {FilePurpose::saveLevel, "x.txt: expected an output file that ends in .json"}};
  for (const auto& [purpose, message] : cases) {
    browse(purpose, at("proposed"));
    const std::string text = message;
    type(text.substr(0, text.find(':')));
    key(keys::enter);
    EXPECT_TRUE(ui.browser.open) << text;
    EXPECT_EQ(ui.browser.problem, text);
    EXPECT_EQ(takeChosenFile(ui.browser, purpose), std::nullopt);
  }
  browse(saveMesh, at("proposed"));
  type("column v1.2");
  key(keys::enter);
  EXPECT_EQ(takeChosenFile(ui.browser, saveMesh), fs::path(at("column v1.2.obj"))) << "a name";
}

TEST_F(Browser, TypingFilters) {
  browse(FilePurpose::openLevel);
  type("LEVEL-1");
  EXPECT_EQ(names(), (Names{"Level-1.json", "level-10.json"}));
  EXPECT_EQ(selected(), "Level-1.json") << "Enter takes the first";
  key(keys::down);
  EXPECT_EQ(selected(), "level-10.json");
  type("xyz");
  EXPECT_TRUE(names().empty());
  key(keys::enter);
  EXPECT_TRUE(ui.browser.open);
  EXPECT_NE(ui.browser.problem.find("there is no such file"), std::string::npos) << ui.browser.problem;
}

TEST_F(Browser, BackspaceGoesUpOnlyWhenNothingIsTyped) {
  browse(FilePurpose::openLevel, at("works"));
  ASSERT_EQ(ui.browser.folder, at("works"));
  type("m");
  key(keys::backspace);
  EXPECT_EQ(ui.browser.folder, at("works"));
  ui.browser.text.clear();
  ++ui.browser.fieldNumber;
  frames(2);
  key(keys::backspace, true);
  EXPECT_EQ(ui.browser.folder, at("works")) << "it is held down: that was for the text";
  key(keys::backspace);
  EXPECT_EQ(ui.browser.folder, fs::path(at("")).parent_path());
}

TEST_F(Browser, TypedPathsLeadThere) {
  browse(FilePurpose::openLevel);
  type("works/");
  EXPECT_EQ(ui.browser.folder, at("works")) << "at once";
  EXPECT_EQ(ui.browser.text, "");
  type("../");
  EXPECT_EQ(ui.browser.folder, fs::path(at("")).parent_path());
  type("nowhere/x.json");
  key(keys::enter);
  EXPECT_TRUE(ui.browser.open);
  EXPECT_NE(ui.browser.problem, "");
  ui.browser.text = at("works/mine.json");
  ++ui.browser.fieldNumber;
  frames(2);
  key(keys::enter);
  EXPECT_FALSE(ui.browser.open);
}

TEST_F(Browser, LosesNoLetterOfAQuickTypist) {
  browseFiles(ui.browser, FilePurpose::openLevel, folder_ / "");
  type("works/mi");
  EXPECT_EQ(ui.browser.folder, at("works"));
  EXPECT_EQ(ui.browser.text, "mi");
  type("ne");
  EXPECT_EQ(ui.browser.text, "mine");
  browseFiles(ui.browser, FilePurpose::saveImage, at("proposal.png"));
  type("other");
  EXPECT_EQ(ui.browser.text, "other");
}

TEST_F(Browser, HomeIsATilde) {
  const char* home = std::getenv("HOME");
  const std::string before = home ? home : "";
  ::setenv("HOME", at("works").c_str(), 1);
  browse(FilePurpose::openLevel);
  type("~/");
  EXPECT_EQ(ui.browser.folder, at("works"));
  ::setenv("HOME", before.c_str(), 1);
}

TEST_F(Browser, EscCloses) {
  browse(FilePurpose::openLevel);
  key(keys::escape);
  EXPECT_FALSE(ui.browser.open);
  EXPECT_FALSE(ui.browser.chosen);
}

TEST_F(Browser, AsksBeforeItReplaces) {
  browse(FilePurpose::saveImage);
  writeText(at("old.png"), "x");
  type("old.png");
  key(keys::enter);
  EXPECT_TRUE(ui.browser.open);
  EXPECT_EQ(ui.browser.replace, at("old.png"));
  key(keys::escape);
  EXPECT_TRUE(ui.browser.open) << "back to the name";
  EXPECT_TRUE(ui.browser.replace.empty());
  key(keys::enter);
  key(keys::enter);
  EXPECT_FALSE(ui.browser.open);
  EXPECT_EQ(takeChosenFile(ui.browser, FilePurpose::saveImage), fs::path(at("old.png")));
}

TEST_F(Browser, WhileItAsksNothingElseCanBeChosen) {
  writeText(at("a.png"), "x");
  browse(FilePurpose::saveImage);
  type("a.png");
  key(keys::enter);
  ASSERT_EQ(ui.browser.replace, at("a.png"));
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  for (float y = 0; y < size.y; y += 13) {
    for (float x = 0; x < size.x; x += 61) {
      moveMouse(x, y);
      frame();
      press(true);
      frame();
      moveMouse(-1, -1);  // not let go over one of the answers
      frame();
      press(false);
      frame();
      ASSERT_EQ(ui.browser.folder, fs::path(at("")).parent_path()) << x << ", " << y;
      ASSERT_EQ(ui.browser.replace, at("a.png")) << x << ", " << y;
      ASSERT_FALSE(ui.browser.chosen) << x << ", " << y;
    }
  }
}

TEST_F(Browser, ProposesNameAndEnding) {
  browse(saveMesh, at("works/sculpture.stl"));
  EXPECT_EQ(ui.browser.folder, at("works"));
  EXPECT_EQ(ui.browser.text, "sculpture.stl");
  type("other");  // the proposed name is selected: typing replaces it
  EXPECT_EQ(ui.browser.text, "other");
  key(keys::enter);
  EXPECT_EQ(takeChosenFile(ui.browser, saveMesh), fs::path(at("works/other.stl")));
  browse(saveMesh, at("works/sculpture.stl"));
  type("other.ply");
  key(keys::enter);
  EXPECT_EQ(takeChosenFile(ui.browser, saveMesh), fs::path(at("works/other.ply")));
}

TEST_F(Browser, ASelectedFilesNameCanBeSavedTo) {
  browse(FilePurpose::saveLevel);
  for (int i = 0; i < 3; ++i) key(keys::down);
  EXPECT_EQ(ui.browser.text, "Level-1.json");
  key(keys::enter);
  EXPECT_EQ(ui.browser.replace, at("Level-1.json"));
}

TEST_F(Browser, NeedsANameToSave) {
  browse(FilePurpose::saveImage);
  key(keys::enter);
  EXPECT_TRUE(ui.browser.open);
  EXPECT_NE(ui.browser.problem, "");
  type("no/such/folder/x.png");
  key(keys::enter);
  EXPECT_TRUE(ui.browser.open);
  EXPECT_NE(ui.browser.problem.find("no such folder"), std::string::npos) << ui.browser.problem;
}

TEST_F(Browser, MakesFolders) {
  browse(FilePurpose::saveImage);
  ui.browser.namingFolder = true;
  frames(2);
  type("new");
  key(keys::enter);
  EXPECT_EQ(ui.browser.folder, at("new"));
  EXPECT_TRUE(fs::is_directory(at("new")));
  ui.browser.namingFolder = true;
  ui.browser.text = "../cube.obj";
  ++ui.browser.fieldNumber;
  frames(2);
  key(keys::enter);
  EXPECT_NE(ui.browser.problem.find("exists"), std::string::npos) << ui.browser.problem;
  key(keys::escape);
  EXPECT_FALSE(ui.browser.namingFolder);
  EXPECT_TRUE(ui.browser.open);
}

TEST_F(Browser, SaysWhatItMayNotRead) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  fs::permissions(at("works"), fs::perms::none);
  browse(FilePurpose::openLevel);
  type("works");
  key(keys::enter);
  EXPECT_NE(ui.browser.problem.find("Permission denied"), std::string::npos) << ui.browser.problem;
  EXPECT_EQ(names().size(), 1u) << "it stays where it was";
  fs::permissions(at("works"), fs::perms::owner_all);
}

TEST_F(Browser, AFolderThatIsGoneIsAProblemAndNoMore) {
  browse(FilePurpose::openLevel, at("works"));
  fs::remove_all(at("works"));
  ui.browser.text = at("works/deep/");
  ++ui.browser.fieldNumber;
  frames(2);
  key(keys::enter);
  EXPECT_NE(ui.browser.problem, "");
  key(keys::escape);
  browse(FilePurpose::openLevel, at("works/mine.json"));
  EXPECT_TRUE(ui.browser.open);
  EXPECT_FALSE(ui.browser.folder.empty()) << "somewhere else";
}

TEST_F(Browser, StaysBelowItsRoot) {
  ui.browser.root = at("works");
  browse(FilePurpose::openLevel);
  EXPECT_EQ(ui.browser.folder, at("works"));
  key(keys::backspace);
  EXPECT_EQ(ui.browser.folder, at("works"));
  type("/");
  EXPECT_EQ(ui.browser.folder, at("works"));
}

TEST_F(Browser, TenThousandFilesAreListedOnceAndDrawnQuickly) {
  fs::create_directory(at("many"));
  for (int i = 0; i < 10000; ++i) writeText(at("many/") + std::to_string(i) + ".json", "");
  browse(FilePurpose::openLevel, at("many"));
  ASSERT_EQ(names().size(), 10000u);
  EXPECT_EQ(names()[2], "2.json");
  writeText(at("many/late.json"), "");
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 60; ++i) {
    handleKey(i % 2 == 0 ? keys::pageDown : keys::down, 0, editor, ui);
    frame();
  }
  const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - start;
  EXPECT_LT(passed.count() / 60, 30) << "milliseconds a frame";
  EXPECT_EQ(names().size(), 10000u) << "not listed anew in every frame";
  const ImDrawData* data = ImGui::GetDrawData();
  EXPECT_LT(data->TotalVtxCount, 60000) << "only what is in sight is drawn";
}

TEST_F(Browser, FitsEveryWindow) {
  for (const auto& [width, height, scale] : {std::tuple{800.0f, 500.0f, 2.0},
                                             {1280.0f, 800.0f, 1.0},
                                             {320.0f, 200.0f, 3.0},
                                             {1.0f, 1.0f, 1.0},
                                             {3840.0f, 2160.0f, 3.0}}) {
    for (const Theme theme : {Theme::dark, Theme::light, Theme::projector}) {
      SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
      ImGui::GetIO().DisplaySize = {width, height};
      setLook(theme, scale * themeScale(theme));
      browse(saveMesh, at("sculpture.stl"));
      ui.browser.problem = "Something did not work, and here is the reason why that was so";
      frames(2);
      ui.browser.replace = at("works/mine.json");
      frames(2);
      ui.browser.open = false;
      frames(2);
    }
  }
}

TEST_F(Browser, IsUsedByTheMouse) {
  browse(FilePurpose::openLevel);
  // Somewhere in the list a double click enters "works", which is the second row.
  bool entered = false;
  for (float y = 160; y < 400 && !entered; y += 6) {
    const Pixel p(700, y);
    moveMouse(static_cast<float>(p.x), static_cast<float>(p.y));
    frames(2);
    for (int i = 0; i < 2; ++i) {
      press(true);
      frame(0.05);
      press(false);
      frame(0.05);
    }
    entered = ui.browser.folder == at("works");
    if (!entered && ui.browser.folder != fs::path(at("")).parent_path()) browse(FilePurpose::openLevel);
    for (int i = 0; i < 20; ++i) frame(0.05);
  }
  EXPECT_TRUE(entered);
}

TEST_F(Browser, KeysOfTheWindowRest) {
  browse(FilePurpose::openLevel);
  const GizmoMode before = editor.gizmoMode;
  handleKey('E', 0, editor, ui);
  handleKey(keys::f2, 0, editor, ui);
  handleKey('Q', keys::control, editor, ui);
  frames(2);
  EXPECT_EQ(editor.gizmoMode, before);
  EXPECT_FALSE(ui.panelsHidden);
  EXPECT_FALSE(ui.requests.quit);
}

}  // namespace
}  // namespace anamorph::testing
