#include "base/same_file.h"

#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace anamorph {
namespace {

namespace fs = std::filesystem;

class SameFile : public testing::Test {
 protected:
  SameFile() {
    std::string name = (fs::temp_directory_path() / "anamorph-same-XXXXXX").string();
    folder = fs::canonical(::mkdtemp(name.data()));
    before = fs::current_path();
    fs::current_path(folder);
    fs::create_directories("a/b");
    for (const char* file : {"one", "other", "a/one"}) std::ofstream(file) << "the same text";
    fs::create_symlink("one", "link");
    fs::create_symlink("link", "link-to-link");
    fs::create_hard_link("one", "hard");
    fs::create_symlink("a/new", "dangling");
    fs::create_symlink("a", "folder-link");
    fs::create_symlink("loop", "loop");
  }
  ~SameFile() override {
    fs::current_path(before);
    fs::remove_all(folder);
  }
  fs::path folder, before;
};

TEST_F(SameFile, IsFoundUnderEveryName) {
  for (const fs::path& name :
       {fs::path("one"), fs::path("./one"), fs::path("a/../one"), fs::path("a//b/../../one"), folder / "one",
        fs::path("link"), fs::path("link-to-link"), fs::path("hard")}) {
    EXPECT_TRUE(isSameFile(name, "one")) << name;
    EXPECT_TRUE(isSameFile("one", name)) << name;
    EXPECT_FALSE(isSameFile(name, "other")) << name;
    EXPECT_FALSE(isSameFile(name, "a/one")) << name;
    EXPECT_FALSE(isSameFile(name, "new")) << name;
  }
}

TEST_F(SameFile, IsKnownByItsPlaceBeforeItIsThere) {
  for (const fs::path& name : {fs::path("a/new"), fs::path("./a/b/../new"), folder / "a/new",
                               fs::path("dangling"), fs::path("folder-link/new")}) {
    EXPECT_TRUE(isSameFile(name, "a/new")) << name;
    EXPECT_FALSE(isSameFile(name, "new")) << name;
  }
  EXPECT_FALSE(isSameFile("loop", "new"));
}

TEST_F(SameFile, DevicesHoldNothing) {
  EXPECT_FALSE(isSameFile("/dev/null", "/dev/null"));
}

TEST_F(SameFile, TheFirstOfSeveralIsNamed) {
  EXPECT_EQ(findSameFile("hard", {"other", "link", "one"}), fs::path("link"));
  EXPECT_EQ(findSameFile("hard", {"other", ""}), std::nullopt);
}

}  // namespace
}  // namespace anamorph
