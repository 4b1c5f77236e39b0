// After a power cut at any moment of a save there is the old document or the new one, and once the save has returned
// the new one.

#include "disk/power_cut.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

#include "base/file.h"
#include "base/folder.h"
#include "edit/session.h"
#include "level/level_json.h"
#include "save_session.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using namespace testing;

std::string textOr(const fs::path& path, const std::string& otherwise) {
  return fs::exists(path) ? std::string(readFile(path, 1 << 24).view()) : otherwise;
}

Document documentAt(const std::string& name) {
  return [name](const fs::path& folder) { return textOr(folder / name, "none"); };
}

Step saves(const std::string& name, const std::string& text) {
  return [=](const fs::path& folder) { writeFile(folder / name, text); };
}

// How a writer may go about it.
struct Writer {
  const char* name;
  bool beside, syncsFile, syncsFolder, survives;
};

void writeAs(const Writer& writer, const fs::path& folder, const std::string& text) {
  const fs::path target = folder / "doc", written = writer.beside ? folder / "temporary" : target;
  const int file = ::open(written.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const std::size_t half = text.size() / 2;
  ASSERT_EQ(::write(file, text.data(), half), static_cast<ssize_t>(half));
  ASSERT_EQ(::write(file, text.data() + half, text.size() - half), static_cast<ssize_t>(text.size() - half));
  if (writer.syncsFile) ::fsync(file);
  ::close(file);
  if (writer.beside) fs::rename(written, target);
  if (writer.syncsFolder && !syncFolder(folder)) FAIL();
}

TEST(PowerCut, IsSeenByTheSimulatorInAWriterThatDoesNotFlush) {
  for (const Writer& writer :
       {Writer{"all of it", true, true, true, true}, Writer{"no sync of the file", true, false, true, false},
        Writer{"no sync of the folder", true, true, false, false},
        Writer{"no sync at all", true, false, false, false}, Writer{"in place", false, true, true, false}}) {
    SCOPED_TRACE(writer.name);
    const auto write = [&](const char* text) {
      return [=](const fs::path& folder) { writeAs(writer, folder, text); };
    };
    const PowerCuts cuts = cutPower({write("the first"), write("the second, longer")}, documentAt("doc"));
    EXPECT_EQ(cuts.fault.empty(), writer.survives) << cuts.fault;
  }
}

TEST(PowerCut, CostsNoFile) {
  const PowerCuts cuts =
      cutPower({saves("doc", "the first"), saves("doc", "the second"), saves("doc", "")}, documentAt("doc"));
  EXPECT_EQ(cuts.fault, "");
  EXPECT_GE(cuts.moments, 3 * 6u) << "open, write, flush, close, rename, flush the folder";
}

// The tests here are worth something only as long as they notice this.
TEST(PowerCut, CostsAFileThatAtomicFileWouldNotFlush) {
  for (const DiskChange unheard : {DiskChange::sync, DiskChange::syncFolder}) {
    EXPECT_NE(
        cutPower({saves("doc", "the first"), saves("doc", "the second")}, documentAt("doc"), unheard).fault,
        "");
  }
}

TEST(PowerCut, CostsNoFileOfManyWrites) {
  const auto write = [](char letter) {
    return [letter](const fs::path& folder) {
      AtomicFile file(folder / "doc");
      for (int i = 0; i < 5; ++i) file.write(std::string(3, static_cast<char>(letter + i)));
      file.commit();
    };
  };
  EXPECT_EQ(cutPower({write('a'), write('n')}, documentAt("doc")).fault, "");
}

TEST(PowerCut, CostsNoFileInANewFolder) {
  const Step save = [](const fs::path& folder) {
    makeFolder(folder / "a/b");
    writeFile(folder / "a/b/doc", "text");
  };
  EXPECT_EQ(cutPower({save}, documentAt("a/b/doc")).fault, "");
}

TEST(PowerCut, CostsNoFileBehindALink) {
  const Step link = [](const fs::path& folder) {
    makeFolder(folder / "far");
    writeFile(folder / "far/doc", "the first");
  };
  const Step save = [](const fs::path& folder) {
    // The simulator knows no links: this one leads into the folder from outside.
    const TemporaryFolder elsewhere;
    fs::create_symlink(folder / "far/doc", elsewhere / "link");
    writeFile(elsewhere / "link", "the second");
  };
  EXPECT_EQ(cutPower({link, save}, documentAt("far/doc")).fault, "");
}

TEST(PowerCut, CostsNothingThatIsSetAside) {
  const Step setAside = [](const fs::path& folder) {
    renameFile(folder / "doc", folder / "doc.broken");
    writeFile(folder / "doc", "anew");
  };
  const Document old = [](const fs::path& folder) {
    const std::string aside = textOr(folder / "doc.broken", "");
    return aside.empty() ? textOr(folder / "doc", "none") : aside;
  };
  EXPECT_EQ(cutPower({saves("doc", "broken"), setAside}, old).fault, "");
}

TEST(PowerCut, CostsNoLevel) {
  const auto titled = [](const std::string& title) {
    return [=](const fs::path& folder) {
      Session session;
      Level level;
      level.text.edit([&](LevelText& text) { text.title = title; });
      session.startNew(level);
      testing::saveTo(session, folder / "mine.json");
    };
  };
  const Document title = [](const fs::path& folder) {
    return fs::exists(folder / "mine.json") ? loadLevel(folder / "mine.json").level.text->title : "none";
  };
  EXPECT_EQ(cutPower({titled("one"), titled("two")}, title).fault, "");
}

}  // namespace
}  // namespace anamorph
