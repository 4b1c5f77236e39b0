// Letters of other scripts than the Latin one: there as soon as a text needs them.

#include "app/fonts.h"

#include <algorithm>
#include <string>
#include <vector>

#include <imgui.h>

#include "app/scripts.h"
#include "gui_fixture.h"
#include "panels/dutch.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;

Letters lettersOf(const std::string& text) {
  Letters letters;
  addLetters(text, letters);
  return letters;
}

TEST(Letters, AreThoseThatAreNotInTheFontsAnyway) {
  EXPECT_TRUE(lettersOf("Plane mirror, 3 × α – … → ∠ é").empty());
  EXPECT_EQ(lettersOf("Жи 鏡 Жи"), (Letters{U'Ж', U'и', U'鏡'}));
  EXPECT_TRUE(lettersOf("\xff\xc3").empty()) << "no UTF-8";
}

TEST(Letters, OfScriptsThatNeedShapingAreNamed) {
  EXPECT_STREQ(findShapedScript(U'ش'), "Arabic");
  EXPECT_STREQ(findShapedScript(U'\u0915'), "Devanagari");
  EXPECT_EQ(findShapedScript(U'Ж'), nullptr);
  EXPECT_EQ(findShapedScript(U'鏡'), nullptr);
  const std::vector<std::string> said = explainMissing(lettersOf("مرحبا и देव"));
  ASSERT_EQ(said.size(), 2u);
  EXPECT_EQ(said[0], "This text needs Arabic letters, which this program cannot draw.");
  EXPECT_EQ(said[1], "This text needs Devanagari letters, which this program cannot draw.");
}

TEST(Letters, ThatAreTooManyAreSaidToBe) {
  Letters letters;
  for (char32_t letter = 0x4e00; letters.size() < 3000; ++letter) letters.insert(letter);
  const auto saysSo = [&] {
    const std::vector<std::string> said = explainMissing(letters);
    return std::any_of(said.begin(), said.end(), [](const std::string& sentence) {
      return sentence.find("more than 3000 different letters") != std::string::npos;
    });
  };
  EXPECT_FALSE(saysSo());
  letters.insert(0x0634);  // of a script that is not drawn anyway
  EXPECT_FALSE(saysSo());
  letters.insert(0x9f00);
  EXPECT_TRUE(saysSo());
}

TEST(Letters, OfEveryScriptHaveADutchName) {
  const std::vector<std::string> keys = dutchKeys();
  const std::set<std::string> known(keys.begin(), keys.end());
  for (char32_t letter = 0; letter < 0x10000; ++letter) {
    if (const char* script = findShapedScript(letter)) {
      ASSERT_EQ(known.count(script), 1u) << script;
    }
  }
}

class FontsTest : public GuiTest {
 protected:
  void SetUp() override {
    if (findFontsFor(lettersOf("鏡거")).empty())
      return cannotRunHere("no font with Chinese and Korean letters: install fonts-wqy-microhei");
    GuiTest::SetUp();
  }
  // Whether all sizes have it.
  bool hasLetter(ImWchar letter) {
    bool has = true;
    for (ImFont* font : {ui().fonts.text, ui().fonts.strong, ui().fonts.title})
      has = has && font && font->FindGlyphNoFallback(letter);
    return has;
  }
  void rename(const std::string& title) {
    Level level = editor().session.level();
    level.text.edit([&](LevelText& text) { text.title = title; });
    editor().session.edit(level);
    frames(2);
  }
};

TEST_F(FontsTest, TakeTheLettersOfTheLevel) {
  openSmallLevel();
  frames(2);
  EXPECT_FALSE(hasLetter(0x0416));
  const ImFont* before = ui().fonts.text;
  frames(5);
  EXPECT_EQ(ui().fonts.text, before) << "loaded once";
  rename("Зеркало, κάτοπτρο, 鏡、거울");
  for (const ImWchar letter : {0x0417, 0x043e, 0x03ba, 0x93e1, 0x3001, 0xac70, 0xc6b8})
    EXPECT_TRUE(hasLetter(letter)) << std::hex << letter;
  EXPECT_EQ(editor().status.text(), "");
  const ImFont* loaded = ui().fonts.text;
  rename("Mirror");
  rename("Зеркало");
  EXPECT_EQ(ui().fonts.text, loaded) << "nothing new is needed";
}

TEST_F(FontsTest, TakeTheLettersOfFileNames) {
  openSmallLevel();
  frames(2);
  ui().browser.open = true;
  ui().browser.listing.entries.push_back({"образец-鏡.json", false});
  ui().recentLevels.push_back("/home/öğrenci/ひかり.json");
  frames(2);
  for (const ImWchar letter : {0x043e, 0x0446, 0x93e1, 0x3072}) EXPECT_TRUE(hasLetter(letter)) << letter;
}

TEST_F(FontsTest, SayOnceWhatTheyCannotDraw) {
  openSmallLevel();
  rename("مرآة");
  EXPECT_EQ(editor().status.text(), "This text needs Arabic letters, which this program cannot draw.");
  EXPECT_FALSE(hasLetter(0x0645));
  EXPECT_EQ(ui().fonts.text->FallbackChar, 0x25af) << "no question marks";
  editor().status.clear();
  rename("مرآة مرآة");
  frames(3);
  EXPECT_EQ(editor().status.text(), "");
}

}  // namespace
}  // namespace anamorph
