#include "base/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <iterator>
#include <string>

#include "error_text.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  void SetUp() override { fs::create_directory(folder); }
  void TearDown() override {
    fs::permissions(folder, fs::perms::owner_all);
    fs::remove_all(folder);
  }

  fs::path at(const std::string& name) const { return folder / name; }
  static std::string contents(const fs::path& path) { return std::string(readFile(path, 1 << 24).view()); }
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }

  const fs::path folder = fs::path(testing::TempDir()) / ("files" + std::to_string(getpid()));
};

TEST_F(Files, WhatWasWrittenIsRead) {
  for (const std::size_t size : {0, 1, 65535, 65536, 65537, 1000000}) {
    std::string bytes(size, 'x');
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(i * 7);
    writeFile(at("a"), bytes);
    const FileBytes read = readFile(at("a"), size);
    ASSERT_TRUE(read.view() == bytes) << size;
    ASSERT_EQ(read.data[size], 0);
  }
}

TEST_F(Files, ReadingRefusesMoreThanTheLimit) {
  writeFile(at("a"), std::string((3 << 20) + 1, 'x'));
  EXPECT_EQ(errorOf([&] { readFile(at("a"), 3 << 20, "use --max-bytes"); }),
            at("a").string() + ": expected at most 3 MiB, got 4 MiB; use --max-bytes");
  EXPECT_EQ(errorOf([&] { readFile(at("a"), 3 << 20); }),
            at("a").string() + ": expected at most 3 MiB, got 4 MiB");
  EXPECT_NO_THROW(readFile(at("a"), (3 << 20) + 1));
}

// A mistake here hangs: then the alarm ends the program.
TEST_F(Files, OnlyFilesAreReadAndReplaced) {
  ::alarm(20);
  ASSERT_EQ(mkfifo(at("pipe").c_str(), 0600), 0);
  EXPECT_EQ(errorOf([&] { readFile(at("pipe"), 10); }),
            at("pipe").string() + ": expected a file, got a pipe");
  EXPECT_EQ(errorOf([&] { writeFile(at("pipe"), "x"); }),
            at("pipe").string() + ": cannot write: expected a file, got a pipe");
  EXPECT_EQ(errorOf([] { readFile("/dev/zero", 1 << 20); }), "/dev/zero: expected a file, got a device");
  fs::create_symlink("/dev/zero", at("zero"));
  EXPECT_EQ(errorOf([&] { readFile(at("zero"), 1 << 20); }),
            at("zero").string() + ": expected a file, got a device");
  ::alarm(0);
}

TEST_F(Files, FilesWithoutAKnownSizeAreReadToTheirEnd) {
  EXPECT_FALSE(contents("/proc/self/status").empty());
}

TEST_F(Files, ReadingRefusesFoldersAndWhatIsMissing) {
  EXPECT_EQ(errorOf([&] { readFile(folder, 10); }), folder.string() + ": expected a file, got a folder");
  EXPECT_EQ(errorOf([&] { readFile(at("none"), 10); }),
            at("none").string() + ": cannot open: No such file or directory");
  EXPECT_EQ(errorOf([] { readFile("", 10); }), "cannot open: No such file or directory");
}

TEST_F(Files, WithoutCommitTheOldFileStaysAndNothingIsLeft) {
  writeFile(at("a"), "old");
  {
    AtomicFile file(at("a"));
    file.write("new");
    EXPECT_EQ(entries(), 2u);
    EXPECT_EQ(contents(at("a")), "old");
  }
  EXPECT_EQ(contents(at("a")), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, CommitReplacesAtOnceAndLeavesNothingElse) {
  writeFile(at("a"), "a long old text");
  AtomicFile file(at("a"));
  file.write("ne");
  file.write("w");
  EXPECT_EQ(contents(at("a")), "a long old text");
  file.commit();
  EXPECT_EQ(contents(at("a")), "new");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, ANewFileHasTheUsualModeAndAnOldOneKeepsItsOwn) {
  const mode_t mask = umask(027);
  writeFile(at("new"), "x");
  umask(mask);
  EXPECT_EQ(static_cast<unsigned>(fs::status(at("new")).permissions()), 0640u);
  fs::permissions(at("new"), fs::perms(0604));
  writeFile(at("new"), "y");
  EXPECT_EQ(static_cast<unsigned>(fs::status(at("new")).permissions()), 0604u);
}

TEST_F(Files, AFullDiskIsAnError) {
  EXPECT_EQ(errorOf([] { writeFile("/dev/full", "x"); }), "/dev/full: cannot write: No space left on device");
}

TEST_F(Files, ADeviceIsWrittenDirectly) {
  EXPECT_NO_THROW(writeFile("/dev/null", "x"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Files, ALinkIsFollowedAndStaysALink) {
  fs::create_directory(at("deep"));
  writeFile(at("deep/target"), "old");
  fs::create_symlink("deep/target", at("link"));
  fs::create_symlink("link", at("link2"));
  writeFile(at("link2"), "new");
  EXPECT_TRUE(fs::is_symlink(at("link")));
  EXPECT_TRUE(fs::is_symlink(at("link2")));
  EXPECT_EQ(contents(at("deep/target")), "new");
}

TEST_F(Files, ALinkToNothingYetMakesItsTarget) {
  fs::create_symlink("later", at("link"));
  writeFile(at("link"), "new");
  EXPECT_TRUE(fs::is_symlink(at("link")));
  EXPECT_EQ(contents(at("later")), "new");
}

TEST_F(Files, ALinkToAFolderOrToItselfIsRefused) {
  fs::create_directory_symlink(folder, at("link"));
  EXPECT_EQ(errorOf([&] { writeFile(at("link"), "x"); }),
            at("link").string() + ": cannot write: expected a file, got a folder");
  fs::create_symlink("loop", at("loop"));
  EXPECT_EQ(errorOf([&] { writeFile(at("loop"), "x"); }),
            at("loop").string() + ": cannot write: Too many levels of symbolic links");
  EXPECT_EQ(entries(), 2u);
}

TEST_F(Files, AFolderOrAMissingOneIsRefused) {
  EXPECT_EQ(errorOf([&] { writeFile(folder, "x"); }),
            folder.string() + ": cannot write: expected a file, got a folder");
  EXPECT_EQ(errorOf([&] { writeFile(at("none/a"), "x"); }),
            at("none/a").string() + ": cannot write: No such file or directory");
  EXPECT_EQ(errorOf([] { writeFile("", "x"); }), "cannot write: expected the name of a file");
  EXPECT_EQ(errorOf([&] { writeFile(at("none") / "", "x"); }),
            at("none").string() + "/: cannot write: expected the name of a file");
}

TEST_F(Files, WithoutPermissionTheOldFileStays) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  writeFile(at("a"), "old");
  fs::permissions(at("a"), fs::perms::owner_read);
  EXPECT_EQ(errorOf([&] { writeFile(at("a"), "new"); }),
            at("a").string() + ": cannot write: Permission denied");
  EXPECT_EQ(contents(at("a")), "old");
  fs::permissions(at("a"), fs::perms::none);
  EXPECT_EQ(errorOf([&] { readFile(at("a"), 10); }), at("a").string() + ": cannot open: Permission denied");
  fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_EQ(errorOf([&] { writeFile(at("b"), "new"); }),
            at("b").string() + ": cannot write: Permission denied");
}

}  // namespace
}  // namespace anamorph
