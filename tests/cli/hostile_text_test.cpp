// What a stranger writes into a level, a mesh or the name of a file never commands the terminal of who looks at it:
// every command, with texts that change colours and titles, forge lines, turn the direction of writing, or are no UTF-8.

#include <sys/stat.h>

#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text.h"
#include "program.h"
#include "source_text.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;
using ::testing::HasSubstr;
using ::testing::Not;

// As bytes, and as JSON writes it.
const std::string evilBytes = "\x1b]0;owned\a\x1b[2J\nlevel.json: all is well\r\x7f\u202e\u2066\u009b31m";
const std::string evilJson = R"(\u001b]0;owned\u0007\u001b[2J\nlevel.json: all is well\r)"
                             "\x7f\u202e\u2066\u009b31m";

std::string quoted(const std::string& name) {
  return "'" + name + "'";
}

// The check does not use what it checks.
void expectHarmless(const std::string& text, const std::string& command) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    ASSERT_TRUE((byte >= 0x20 && byte != 0x7f) || byte == '\n')
        << command << ": byte " << int(byte) << " of\n"
        << text;
    if (byte < 0x80) continue;
    const std::size_t length = characterLength(std::string_view(text).substr(i));
    ASSERT_GT(length, 0u) << command << ": no UTF-8 at byte " << i << " of\n" << text;
    const std::string character = text.substr(i, length);
    const bool eightBit = byte == 0xC2 && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    const bool turns = (character >= "\u202A" && character <= "\u202E") ||
                       (character >= "\u2066" && character <= "\u2069") || character == "\u2028";
    ASSERT_FALSE(eightBit || turns) << command << ": byte " << i << " of\n" << text;
    i += length - 1;
  }
  EXPECT_THAT("\n" + text, Not(HasSubstr("\nlevel.json: all is well"))) << command;
}

class HostileText : public ::testing::Test {
 protected:
  HostileText() { ::setenv("ANAMORPH_RESOURCES", ANAMORPH_SOURCE_DIR, 1); }

  std::string write(const std::string& name, const std::string& text) const {
    writeText(folder / name, text);
    return quoted(folder / name);
  }

  // The plane level with something else in place of a part of it.
  static std::string levelWith(const std::string& part, const std::string& other) {
    std::string level = readAll(std::string(ANAMORPH_LEVELS) + "/1-plane.json");
    const std::size_t at = level.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return level.replace(at, part.size(), other);
  }
  static std::string evilLevel() {
    return levelWith("\"title\": \"The plane mirror\"",
                     "\"" + evilJson + "\": 1, \"title\": \"" + evilJson + "\"");
  }

  // All commands for a FILE and what comes behind it.
  std::vector<std::string> commandsFor(const std::string& file) const {
    std::vector<std::string> commands{
        "check " + file,
        "match " + file + " --size 32",
        "deform " + file + " -o " + quoted(folder / (evilBytes + "s.obj")),
        "deform " + file + " --json -o " + quoted(folder / "s.obj"),
        "render " + file + " --size 32x32 -o " + quoted(folder / (evilBytes + "p.png")),
        "export " + file + " --check --size 32 -o " + quoted(folder / (evilBytes + "r.html")) + " -o " +
            quoted(folder / "s.pdf"),
        "export " + file + " -o " + quoted(folder / evilBytes),
        "render " + file + " -o " + quoted(folder / (evilBytes + "/none/p.png"))};
#ifdef ANAMORPH_GUI
    commands.insert(commands.end(),
                    {"screenshot " + file + " --size 320x200 -o " + quoted(folder / (evilBytes + "w.png")),
                     "bench-drag " + file + " --frames 10 --size 320x200", "open " + file, file});
#endif
    return commands;
  }

  void expectAllHarmless(const std::vector<std::string>& commands) const {
    for (const std::string& command : commands) {
      const Result result = runWith("env -u DISPLAY -u WAYLAND_DISPLAY", command);
      EXPECT_LT(result.exitCode, 3) << command << "\n" << result.err;
      EXPECT_NE(result.out + result.err, "") << command;
      expectHarmless(result.out, command);
      expectHarmless(result.err, command);
    }
  }

  TemporaryFolder folder;
};

TEST_F(HostileText, OfALevelIsPrintedEscaped) {
  const std::string file = write("level.json", evilLevel());
  expectAllHarmless(commandsFor(file));
  EXPECT_THAT(run("check " + file).out,
              HasSubstr(R"(level "\033]0;owned\007\033[2J\nlevel.json: all is well)"));
}

TEST_F(HostileText, OfFileNamesIsPrintedEscaped) {
  expectAllHarmless(commandsFor(write(evilBytes + "\xff.json", evilLevel())));
  expectAllHarmless(commandsFor(quoted(folder / (evilBytes + "missing.json"))));
  expectAllHarmless({"check " + write(evilBytes + ".obj", "v 0 0 0\n"), quoted(evilBytes),
                     "check " + quoted(evilBytes), "match 1-plane " + quoted(folder / (evilBytes + ".stl")),
                     "match " + quoted(evilBytes + ".obj"), "match 1-plane --size " + quoted(evilBytes),
                     "match 1-plane " + quoted("--" + evilBytes),
                     "export 1-plane -o s.pdf --scale " + quoted(evilBytes)});
}

TEST_F(HostileText, OfBrokenFilesIsPrintedEscaped) {
  const std::string box = R"({"type": "box", "size": [6, 2, 2], "segments": 32})";
  const std::vector<std::string> levels{
      levelWith(box, "{\"type\": \"file\", \"path\": \"" + evilJson + ".obj\"}"),
      levelWith(box, "{\"type\": \"" + evilJson + "\"}"),
      levelWith("\"anamorph-level\"", "\"" + evilJson + "\""),
      "{\"" + evilJson + "\": 1, \"" + evilJson + "\": 2}",
      "{\"a\": " + evilBytes,
      "{“a”: 1}",
      "\xff"};
  std::vector<std::string> commands;
  for (const std::string& text : levels) {
    commands.push_back("check " + write("broken" + std::to_string(commands.size()) + ".json", text));
  }
  commands.push_back("check " +
                     write("a.ply", "ply\ncomment " + evilBytes + "\nformat " + evilBytes + " 1.0\n"));
  commands.push_back("check " + write("b.obj", "v " + evilBytes + "\n"));
  commands.push_back("check " + write("c.stl", "solid " + evilBytes + "\nfacet " + evilBytes + "\n"));
  expectAllHarmless(commands);
}

TEST_F(HostileText, OfInstalledLevelsIsPrintedEscaped) {
  ::mkdir((folder / "levels").c_str(), 0777);
  write("levels/" + evilBytes + ".json", evilLevel());
  write("levels/" + evilBytes + "broken.json", "{");
  ::setenv("ANAMORPH_RESOURCES", (folder / "").c_str(), 1);
  expectAllHarmless({"levels", "levels --size 64 -o " + quoted(folder / evilBytes)});
  ::unsetenv("ANAMORPH_RESOURCES");
}

TEST(Printing, GoesThroughOnePlace) {
  const std::regex prints(R"(fmt::print|std::c(out|err|log)\b|\b(f?printf|f?puts|fputc|fwrite|perror)\()");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(sourceFolder / "src")) {
    const std::filesystem::path& file = entry.path();
    if ((file.extension() != ".cpp" && file.extension() != ".h") || file.stem() == "print") continue;
    EXPECT_FALSE(std::regex_search(textOf(file), prints)) << file << ": cli/print.h is for that";
  }
}

}  // namespace
}  // namespace anamorph
