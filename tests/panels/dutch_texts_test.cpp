// Whether everything that people read has a translation, by what stands in the source. xgettext reads it, as the
// compiler does; what is drawn in the end is looked at in language_test.cpp.

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cannot_run_here.h"
#include "panels/dutch.h"
#include "source_text.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using namespace anamorph::testing;

// Not to be translated: identities, endings, formats, words of files. One a line; of a longer text its first line.
std::set<std::string> untranslated() {
  std::set<std::string> lines;
  std::istringstream text(textOf(ANAMORPH_TEST_DATA "/untranslated.txt"));
  for (std::string line; std::getline(text, line);) lines.insert(line);
  return lines;
}

// A string of a .po file, without its quotes.
std::string unescaped(const std::string& quoted) {
  std::string text;
  for (std::size_t i = 1; i + 1 < quoted.size(); ++i) {
    const bool escape = quoted[i] == '\\';
    if (escape) ++i;
    text += !escape ? quoted[i] : quoted[i] == 'n' ? '\n' : quoted[i] == 't' ? '\t' : quoted[i];
  }
  return text;
}

struct Literal {
  std::string text;
  std::string places;  // "#: file:line file:line"
};

// What xgettext finds in the files: with "-k -ktr -ktrFormat" all that is translated, with "-a" all string literals.
std::vector<Literal> literalsIn(const std::vector<fs::path>& files, const std::string& arguments) {
  std::string command = "xgettext --language=C++ --from-code=UTF-8 --no-wrap --output=- " + arguments;
  for (const fs::path& file : files) command += " '" + file.string() + "'";
  FILE* const pipe = ::popen((command + " 2>/dev/null").c_str(), "r");  // it warns of every empty text
  std::string output;
  for (int c = 0; (c = std::fgetc(pipe)) != EOF;) output += static_cast<char>(c);
  EXPECT_EQ(::pclose(pipe), 0) << command;
  std::vector<Literal> literals(1);
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    Literal& last = literals.back();
    if (line.starts_with("#:")) last.places += line;
    if (line.starts_with("msgid ")) last.text = unescaped(line.substr(6));
    if (line.starts_with("\"")) last.text += unescaped(line);
    if (line.starts_with("msgstr ")) literals.emplace_back();
  }
  std::erase_if(literals, [](const Literal& literal) { return literal.places.empty(); });
  return literals;
}

std::vector<fs::path> sourceFiles(const std::string& room = "") {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(sourceFolder / "src" / room)) {
    if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// Whose texts reach people: the panels, the rooms whose names and sentences they show, and whoever translates or gives
// notice. What the others say goes to the command line, to logs and into files, which stay English.
std::vector<fs::path> filesThatSpeak() {
  std::vector<fs::path> files;
  const std::set<std::string> rooms{"anamorphosis", "edit",     "exports", "optics",
                                    "panels",       "pipeline", "raytrace"};
  const std::vector<const char*> marks{" tr(", "(tr(", "trFormat(", "Notice{"};
  for (const fs::path& file : sourceFiles()) {
    const std::string code = textOf(file);
    const bool speaks = std::any_of(marks.begin(), marks.end(),
                                    [&](const char* mark) { return code.find(mark) != std::string::npos; });
    if (speaks || rooms.count(file.parent_path().filename()) != 0) files.push_back(file);
  }
  return files;
}

// A name in a file, such as "tolerancePixels" or "camera_rays".
bool isIdentifier(const std::string& text) {
  return isSmall(text[0]) && std::all_of(text.begin(), text.end(),
                                         [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

bool isMarkup(const std::string& text) {
  return text[0] == '<' || text[0] == '&' || text.find("</") != std::string::npos;
}

std::string firstLineOf(const std::string& text) {
  const std::size_t begin = text.find_first_not_of('\n');
  return text.substr(begin, text.find('\n', begin) - begin);
}

class SourceTexts : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("xgettext --version >/dev/null 2>&1") != 0) return cannotRunHere("no xgettext");
    for (const std::string& key : dutchKeys()) known.insert(key);
  }
  std::set<std::string> known;
};

TEST_F(SourceTexts, AreInTheDutchTableWhereTheyAreTranslated) {
  const std::vector<Literal> literals = literalsIn(sourceFiles(), "-k -ktr -ktrFormat");
  EXPECT_GT(literals.size(), 150u);
  for (const Literal& literal : literals) {
    EXPECT_EQ(known.count(literal.text), 1u)
        << literal.places << "\n\"" << literal.text << "\"\nis not in assets/languages/nl.json";
  }
}

// A translation that is no format would end the program: trFormat() shows the English text then.
TEST(TranslatedFormats, AreMadeByTrFormat) {
  for (const fs::path& file : sourceFiles()) {
    const std::string code = textOf(file);
    for (std::size_t at = 0; (at = code.find("fmt::runtime(", at)) != std::string::npos; ++at) {
      const bool checked = at >= 9 && code.compare(at - 9, 9, "trFormat(") == 0;
      EXPECT_TRUE(checked || file.filename() == "language.h")
          << file << ": fmt::runtime outside of trFormat()";
    }
  }
}

TEST_F(SourceTexts, AreInTheDutchTableUnlessTheyAreNamesOrFormats) {
  for (const std::string& line : untranslated()) known.insert(line);
  const std::vector<fs::path> panels = sourceFiles("panels");
  std::set<std::string> inPanels;  // there single words are texts, too
  for (const Literal& literal : literalsIn(panels, "-a")) inPanels.insert(literal.text);
  std::size_t found = 0;
  for (const Literal& literal : literalsIn(filesThatSpeak(), "-a")) {
    if (!hasWord(literal.text)) continue;
    const std::string text = firstLineOf(literal.text);
    if (text.starts_with("##") || isMarkup(text)) continue;
    if (isIdentifier(text) && inPanels.count(literal.text) == 0) continue;
    ++found;
    EXPECT_TRUE(known.count(literal.text) != 0 || known.count(text) != 0)
        << literal.places << "\n\"" << text
        << "\"\nis neither in assets/languages/nl.json nor in tests/data/untranslated.txt";
  }
  EXPECT_GT(found, 500u);
}

// Of a rule that is broken in one place it is said where.
void expectNone(const std::vector<fs::path>& files, const std::regex& wrong, const char* why) {
  for (const fs::path& file : files) {
    const std::string code = textOf(file);
    for (std::sregex_iterator match(code.begin(), code.end(), wrong), end; match != end; ++match)
      ADD_FAILURE() << file << ": " << match->str() << "\n" << why;
  }
}

// Numbers that people read are written at one place, by trFormat() and shownFormat(): with the language's decimal sign,
// without exponents, and never "-0.00".
TEST(ShownNumbers, AreWrittenAtOnePlace) {
  const std::regex ownFormat("fmt::format\\(\\s*\"[^\"]*\\{[0-9]*:[^\"}]*[fge]\\}");
  for (const char* room : {"edit", "panels", "optics"})
    expectNone(sourceFiles(room), ownFormat, "use trFormat() or shownFormat() (base/language.h)");
}

TEST(DutchNumbers, HaveDecimalCommas) {
  const std::regex point("[0-9]\\.[0-9]"), place("\\{[^}]*\\}");
  for (const auto& [english, dutch] : dutchTexts()) {
    const std::string text = std::regex_replace(dutch, place, "");
    EXPECT_FALSE(std::regex_search(text, point)) << dutch;
  }
}

// One word for one thing.
TEST(DutchWords, AreOneForOneThing) {
  std::map<std::string, std::string> texts;
  for (const auto& [english, dutch] : dutchTexts()) texts[english] = dutch;
  EXPECT_NE(texts.at("Mirror"), texts.at("Reflection"));
  for (const auto& [english, dutch] : texts) {
    for (const char* other : {"diepteschaal", "weerspiegeling", "variëteit", "gaaf"})
      EXPECT_EQ(dutch.find(other), std::string::npos) << dutch;
  }
}

}  // namespace
}  // namespace anamorph
