#include "base/temporary_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "base/file.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

TEST(TemporaryFiles, OfKilledProgramsAreClearedAwayByTheNextSave) {
  const fs::path folder = fs::path(testing::TempDir()) / ("left" + std::to_string(getpid()));
  fs::create_directory(folder);
  const auto leave = [&](const char* name, std::chrono::minutes age) {
    std::ofstream(folder / name) << "half a docu";
    fs::last_write_time(folder / name, fs::file_time_type::clock::now() - age);
  };
  leave(".anamorph-aB3xYz", std::chrono::minutes(20));
  leave(".anamorph-Fresh1", std::chrono::minutes(1));
  leave(".anamorph-longer1", std::chrono::minutes(20));
  leave("anamorph-123456", std::chrono::minutes(20));
  fs::create_directory(folder / ".anamorph-Folder");
  writeFile(folder / "doc", "text");
  EXPECT_FALSE(fs::exists(folder / ".anamorph-aB3xYz"));
  EXPECT_TRUE(fs::exists(folder / ".anamorph-Fresh1")) << "somebody may still be writing it";
  for (const char* others : {".anamorph-longer1", "anamorph-123456", ".anamorph-Folder", "doc"}) {
    EXPECT_TRUE(fs::exists(folder / others)) << others;
  }
  fs::remove_all(folder);
}

TEST(TemporaryFiles, AreMoreThanThereArePlacesForTheirNames) {
  const fs::path folder = fs::path(testing::TempDir()) / ("many" + std::to_string(getpid()));
  fs::create_directory(folder);
  {
    std::vector<std::unique_ptr<TemporaryFile>> files;
    for (int i = 0; i < 100; ++i) {
      files.push_back(std::make_unique<TemporaryFile>(folder, 0600));
      ASSERT_GE(files.back()->descriptor(), 0);
    }
  }
  EXPECT_TRUE(fs::is_empty(folder));
  fs::remove_all(folder);
}

TEST(ScratchFolders, GoWithTheirFile) {
  fs::path file;
  {
    ScratchFolder folder;
    file = folder.file("output.obj");
    EXPECT_EQ(file.filename(), "output.obj");
    writeFile(file, "v 0 0 0");
  }
  EXPECT_FALSE(fs::exists(file.parent_path()));
}

// A command whose output goes to standard output, stopped by Ctrl+C.
TEST(ScratchFolders, GoWithASignal) {
  const fs::path place = fs::path(testing::TempDir()) / ("interrupted" + std::to_string(getpid()));
  fs::create_directory(place);
  const auto stopWithin = [&] {
    ::setenv("TMPDIR", place.c_str(), 1);
    removeTemporariesOnSignals();
    ScratchFolder folder;
    const fs::path file = folder.file("output.obj");
    std::ofstream(file) << "v 0 0 0";
    const TemporaryFile half(file.parent_path(), 0600);
    ::raise(SIGINT);
  };
  EXPECT_EXIT(stopWithin(), testing::KilledBySignal(SIGINT), "");
  EXPECT_TRUE(fs::is_empty(place));
  fs::remove_all(place);
}

}  // namespace
}  // namespace anamorph
