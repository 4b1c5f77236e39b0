// A file that is replaced keeps what it was given: rights, owner, attributes; what cannot be kept is said.

#include "base/kept_attributes.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/file.h"
#include "cannot_run_here.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using Texts = std::vector<std::string>;

class KeptAttributes : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(folder);
    writeFile(file, "old");
  }
  void TearDown() override { fs::remove_all(folder); }

  struct stat info() const {
    struct stat found {};
    EXPECT_EQ(::stat(file.c_str(), &found), 0);
    return found;
  }
  std::string attribute(const char* name) const {
    char value[256];
    const ssize_t size = ::getxattr(file.c_str(), name, value, sizeof value);
    return size < 0 ? "none" : std::string(value, static_cast<std::size_t>(size));
  }

  const fs::path folder = fs::path(testing::TempDir()) / ("kept" + std::to_string(getpid()));
  const fs::path file = folder / "file";
};

TEST_F(KeptAttributes, RightsAreButNotThoseToActAsSomebodyElse) {
  for (const mode_t mode : {0600, 0640, 0666, 0755, 0604, 04755, 02755, 06711, 01644}) {
    ASSERT_EQ(::chmod(file.c_str(), mode), 0);
    EXPECT_EQ(writeFile(file, "new"), Texts{});
    EXPECT_EQ(info().st_mode & 07777, mode & 0777) << std::oct << mode;
  }
}

TEST_F(KeptAttributes, OwnerAndGroupAre) {
  const uid_t owner = ::geteuid() == 0 ? 12345 : ::geteuid();
  std::vector<gid_t> groups(1024);
  groups.resize(static_cast<std::size_t>(std::max(::getgroups(1024, groups.data()), 0)));
  const gid_t group = ::geteuid() == 0 ? 54321 : groups.empty() ? ::getegid() : groups.back();
  ASSERT_EQ(::chown(file.c_str(), owner, group), 0);
  EXPECT_EQ(writeFile(file, "new"), Texts{});
  EXPECT_EQ(info().st_uid, owner);
  EXPECT_EQ(info().st_gid, group);
}

TEST_F(KeptAttributes, ThoseThatCannotBeAreSaidAndNobodyGetsMore) {
  if (::geteuid() != 0) GTEST_SKIP() << "root may make files of others, who else may not";
  ASSERT_EQ(::chown(file.c_str(), 12345, 54321), 0);
  ASSERT_EQ(::chmod(file.c_str(), 0662), 0);
  ASSERT_EQ(::chmod(folder.c_str(), 0777), 0);
  ASSERT_EQ(::setegid(23456), 0);
  ASSERT_EQ(::seteuid(23456), 0);
  const Texts lost = writeFile(file, "new");
  ASSERT_EQ(::seteuid(0), 0);
  ASSERT_EQ(::setegid(0), 0);
  EXPECT_EQ(lost,
            (Texts{file.string() + ": replaced, but its owner could not be kept: Operation not permitted",
                   file.string() + ": replaced, but its group could not be kept: Operation not permitted"}));
  EXPECT_EQ(info().st_mode & 0777, 0622u) << "the other group may what anybody may";
}

TEST_F(KeptAttributes, ExtendedOnesAre) {
  if (::setxattr(file.c_str(), "user.colour", "red", 3, 0) != 0)
    return cannotRunHere("no extended attributes");
  ASSERT_EQ(::setxattr(file.c_str(), "user.empty", "", 0, 0), 0);
  EXPECT_EQ(writeFile(file, "new"), Texts{});
  EXPECT_EQ(attribute("user.colour"), "red");
  EXPECT_EQ(attribute("user.empty"), "");
  EXPECT_EQ(attribute("user.none"), "none");
}

// As the kernel has it: user 1234 may read and write.
std::string accessList() {
  struct Entry {
    std::uint16_t tag, rights;
    std::uint32_t id;
  };
  constexpr std::uint32_t nobody = 0xffffffff;
  const Entry entries[] = {{1, 6, nobody}, {2, 6, 1234}, {4, 4, nobody}, {16, 6, nobody}, {32, 0, nobody}};
  const std::uint32_t version = 2;
  return std::string(reinterpret_cast<const char*>(&version), sizeof version) +
         std::string(reinterpret_cast<const char*>(entries), sizeof entries);
}

TEST_F(KeptAttributes, TheAccessControlListIs) {
  const std::string list = accessList();
  if (::setxattr(file.c_str(), "system.posix_acl_access", list.data(), list.size(), 0) != 0) {
    return cannotRunHere("no access control lists");
  }
  const mode_t mode = info().st_mode;
  EXPECT_EQ(writeFile(file, "new"), Texts{});
  EXPECT_EQ(attribute("system.posix_acl_access"), list);
  EXPECT_EQ(info().st_mode, mode);
}

TEST_F(KeptAttributes, WhatTheFolderHandsDownIsNotAdded) {
  const std::string list = accessList();
  if (::setxattr(folder.c_str(), "system.posix_acl_default", list.data(), list.size(), 0) != 0) {
    return cannotRunHere("no access control lists");
  }
  EXPECT_EQ(writeFile(file, "new"), Texts{});
  EXPECT_EQ(attribute("system.posix_acl_access"), "none") << "the old one had none";
}

TEST_F(KeptAttributes, OtherNamesKeepTheOldContentsAndAreSaid) {
  fs::create_hard_link(file, folder / "second");
  EXPECT_EQ(writeFile(file, "new"),
            Texts{file.string() + ": replaced, but its other name (a hard link) still has the old contents"});
  EXPECT_EQ(readFile(folder / "second", 10).view(), "old");
  EXPECT_EQ(writeFile(file, "newer"), Texts{}) << "it has one name now";
  fs::create_hard_link(file, folder / "third");
  fs::create_hard_link(file, folder / "fourth");
  EXPECT_EQ(
      writeFile(file, "newest"),
      Texts{file.string() + ": replaced, but its 2 other names (hard links) still have the old contents"});
}

TEST_F(KeptAttributes, WhileItIsWrittenItIsPrivate) {
  ASSERT_EQ(::chmod(file.c_str(), 0666), 0);
  AtomicFile written(file);
  for (const auto& entry : fs::directory_iterator(folder)) {
    EXPECT_EQ(entry.status().permissions(), fs::perms(entry.path() == file ? 0666 : 0600)) << entry.path();
  }
}

}  // namespace
}  // namespace anamorph
