// Every call of a save fails once, in every way: what the user is told, and what is there then.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/xattr.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>
#include <vector>

#include "base/file.h"
#include "base/folder.h"
#include "cli/program.h"
#include "disk/disk_calls.h"
#include "disk/disk_model.h"
#include "error_text.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using namespace testing;
using namespace std::chrono_literals;

constexpr std::size_t maxCalls = 100;

// What came of one save with a fault in it.
struct Outcome {
  std::optional<DiskCall> failed;  // nothing: the save has fewer calls
  std::string error;               // "no error": it went well
  std::vector<std::string> lost;
  DiskImage disk;
};

class DiskFaults : public ::testing::Test {
 protected:
  // A save in two writes over an old file that has an attribute of its own, where the file system has those.
  Outcome saveWith(DiskFault fault) {
    const TemporaryFolder folder;
    const fs::path root = fs::path(folder / "").parent_path();
    file_ = root / "doc";
    writeFile(file_, "old");
    ::setxattr(file_.c_str(), "user.colour", "red", 3, 0);
    Outcome outcome;
    const DiskWatch watch(root, fault);
    outcome.error = errorOf([&] {
      AtomicFile file(file_);
      file.write("new ");
      file.write("text");
      outcome.lost = file.commit();
    });
    outcome.failed = watch.failed();
    outcome.disk = readImage(root);
    return outcome;
  }
  fs::path file_;
};

const DiskImage oldDisk{{"doc", "old"}}, newDisk{{"doc", "new text"}};

TEST_F(DiskFaults, LeaveTheOldFileAndSayWhatAndWhere) {
  for (const int error : {ENOSPC, EIO, EDQUOT, EROFS}) {
    std::size_t index = 0;
    for (; index < maxCalls; ++index) {
      const Outcome outcome = saveWith({index, error});
      if (!outcome.failed) break;
      SCOPED_TRACE(describe(*outcome.failed) + ": " + std::strerror(error));
      if (outcome.failed->change == DiskChange::attribute) {
        EXPECT_EQ(outcome.disk, newDisk);
        ASSERT_EQ(outcome.lost.size(), 1u);
        EXPECT_TRUE(outcome.lost[0].starts_with(file_.string() + ": replaced, but its "));
        EXPECT_TRUE(outcome.lost[0].ends_with(std::strerror(error)));
        continue;
      }
      const bool renamed = outcome.disk == newDisk;
      EXPECT_TRUE(renamed || outcome.disk == oldDisk) << "no temporary, and one of both";
      const bool afterRename = outcome.failed->path.empty();  // the folder itself is flushed
      EXPECT_EQ(renamed, afterRename || outcome.error == "no error");
      if (outcome.failed->change == DiskChange::close && afterRename) continue;  // flushed already
      if (afterRename) {
        EXPECT_EQ(outcome.error, "no error") << "it is written";
        ASSERT_EQ(outcome.lost.size(), 1u);
        EXPECT_EQ(outcome.lost[0],
                  file_.string() + ": written, but it may not outlive a power cut: " + std::strerror(error));
        continue;
      }
      EXPECT_EQ(outcome.error, file_.string() + ": cannot write: " + std::strerror(error));
    }
    EXPECT_GE(index, 9u)
        << "open, write, write, attributes, flush, close, rename; open, flush and close the folder";
    EXPECT_LT(index, maxCalls);
  }
}

TEST_F(DiskFaults, ThatAreSignalsChangeNothing) {
  for (std::size_t index = 0;; ++index) {
    const Outcome outcome = saveWith({index, EINTR});
    if (!outcome.failed) break;
    if (outcome.failed->change == DiskChange::attribute) continue;  // these never say EINTR
    SCOPED_TRACE(describe(*outcome.failed));
    EXPECT_EQ(outcome.error, "no error");
    EXPECT_EQ(outcome.disk, newDisk);
    EXPECT_EQ(outcome.lost, std::vector<std::string>{});
  }
}

TEST_F(DiskFaults, ThatTakeOnlyAPartAreGoneOnWith) {
  const TemporaryFolder folder;
  const fs::path root = fs::path(folder / "").parent_path();
  DiskWatch watch(root);
  watch.writeInHalves();
  writeFile(root / "doc", "a text that is written bit by bit");
  EXPECT_EQ(readImage(root), (DiskImage{{"doc", "a text that is written bit by bit"}}));
  EXPECT_GE(watch.calls().size(), 9u);
}

TEST_F(DiskFaults, OfANewFolderAreTold) {
  for (std::size_t index = 0;; ++index) {
    const TemporaryFolder folder;
    const fs::path root = fs::path(folder / "").parent_path();
    const DiskWatch watch(root, DiskFault{index, EIO});
    const std::string error = errorOf([&] { makeFolder(root / "a/b"); });
    if (!watch.failed()) break;
    SCOPED_TRACE(describe(*watch.failed()));
    if (watch.failed()->change == DiskChange::close) continue;
    EXPECT_TRUE(error.starts_with(root.string() + "/a")) << error;
    EXPECT_TRUE(error.ends_with(": cannot make the folder: Input/output error")) << error;
  }
}

TEST_F(DiskFaults, WhenSomethingIsSetAsideAreTold) {
  for (std::size_t index = 0;; ++index) {
    const TemporaryFolder folder;
    const fs::path root = fs::path(folder / "").parent_path();
    writeFile(root / "doc", "text");
    const DiskWatch watch(root, DiskFault{index, EIO});
    const std::string error = errorOf([&] { renameFile(root / "doc", root / "doc.broken"); });
    if (!watch.failed()) break;
    SCOPED_TRACE(describe(*watch.failed()));
    if (watch.failed()->change == DiskChange::close) continue;
    const bool moved = fs::exists(root / "doc.broken");
    EXPECT_EQ(error, (root / "doc").string() +
                         (moved ? ": renamed to doc.broken, but it may not outlive a power cut"
                                : ": cannot be renamed to doc.broken") +
                         ": Input/output error");
  }
}

TEST_F(DiskFaults, OfTheClockTakeNoFileFromWhoStillWritesIt) {
  for (const std::chrono::hours ahead : {-24 * 365h, 24 * 365h}) {
    SCOPED_TRACE(std::to_string(ahead.count()) + " hours ahead of the disk");
    const TemporaryFolder folder;
    const fs::path root = fs::path(folder / "").parent_path();
    writeFile(root / ".anamorph-killed", "half a docu");
    fs::last_write_time(root / ".anamorph-killed", fs::file_time_type::clock::now() - 20min);
    DiskWatch watch(root);
    watch.setClockAhead(ahead);
    AtomicFile first(root / "first");
    writeFile(root / "second", "2");
    first.write("1");
    EXPECT_EQ(errorOf([&] { first.commit(); }), "no error");
    EXPECT_EQ(readImage(root), (DiskImage{{"first", "1"}, {"second", "2"}}));
  }
}

}  // namespace
}  // namespace anamorph
