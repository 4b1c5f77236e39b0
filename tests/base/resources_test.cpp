#include "base/resources.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace anamorph {
namespace {

namespace fs = std::filesystem;

TEST(Resources, TheFolderThatTheEnvironmentNamesGoesFirst) {
  const fs::path folder = fs::path(testing::TempDir()) / ("resources" + std::to_string(getpid()));
  fs::create_directories(folder / "levels");
  setenv("ANAMORPH_RESOURCES", folder.c_str(), 1);
  EXPECT_EQ(resourceFolder(), folder);
  fs::remove_all(folder);
  // Without levels in it, the search goes on.
  EXPECT_TRUE(fs::is_directory(resourceFolder() / "levels"));
  EXPECT_NE(resourceFolder(), folder);
  unsetenv("ANAMORPH_RESOURCES");
}

TEST(Resources, AreFoundInTheSourceTree) {
  EXPECT_TRUE(fs::exists(resourceFolder() / "levels" / "1-plane.json"));
}

}  // namespace
}  // namespace anamorph
