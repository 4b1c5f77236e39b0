#include "app/progress_file.h"

#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file.h"
#include "cli/program.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;

TEST(ProgressFile, RoundTrip) {
  const TemporaryFolder folder;
  const std::string path = folder / "state/anamorph/progress.json";
  for (const LessonProgress& progress :
       {LessonProgress{},
        LessonProgress{{"plane", {"a", "b"}}, {"a \"quoted\" é lesson", {"1"}}, {"x", {}}}}) {
    saveProgress(path, {}, {});
    saveProgress(path, {}, progress);
    std::string message;
    LessonProgress loaded = loadProgress(path, message);
    loaded["x"];  // a lesson without steps need not be remembered
    LessonProgress expected = progress;
    expected["x"];
    EXPECT_EQ(loaded, expected);
    EXPECT_EQ(message, "");
  }
}

TEST(ProgressFile, ABrokenOneIsKeptAndSaid) {
  const TemporaryFolder folder;
  const std::string path = folder / "progress.json";
  const std::pair<const char*, const char*> bad[] = {
      {"{", "syntax error"},
      {R"({"format": "other"})", "/format: expected \"anamorph-progress\", got \"other\""},
      {R"({"format": "anamorph-progress"})", "/lessons: expected an object, got nothing"},
      {R"({"format": "anamorph-progress", "lessons": {"a": 3}})",
       "/lessons/a: expected an array of step ids, got 3"},
      {R"({"format": "anamorph-progress", "lessons": {"a": [1]}})",
       "/lessons/a: expected an array of step ids, got 1"}};
  for (const auto& [text, expected] : bad) {
    writeFile(path, text);
    std::string message;
    EXPECT_TRUE(loadProgress(path, message).empty());
    EXPECT_NE(message.find(expected), std::string::npos) << message;
    EXPECT_EQ(readFile(path, 1000).view(), text) << "nothing is lost by reading";
    saveProgress(path, {{"x", {"y"}}}, {{"x", {"y", "z"}}});
    EXPECT_EQ(loadProgress(path, message), (LessonProgress{{"x", {"y", "z"}}})) << "all that is known";
    EXPECT_EQ(readFile(path + ".broken", 1000).view(), text);
  }
}

TEST(ProgressFile, ABrokenOneThatCannotBeSetAsideStays) {
  const TemporaryFolder folder;
  const std::string path = folder / "progress.json";
  writeFile(path, "{");
  std::filesystem::create_directories(path + ".broken/in the way");
  EXPECT_THROW(saveProgress(path, {}, {{"x", {"y"}}}), Error);
  EXPECT_EQ(readFile(path, 1000).view(), "{");
}

TEST(ProgressFile, OfTwoWindowsIsUnitedAndForgottenWhenAsked) {
  const TemporaryFolder folder;
  const std::string path = folder / "progress.json";
  std::string message;
  saveProgress(path, {}, {{"plane", {"a", "b"}}});
  saveProgress(path, {}, {{"plane", {"c"}}, {"sphere", {"a"}}});  // a window that was opened before
  const LessonProgress all{{"plane", {"a", "b", "c"}}, {"sphere", {"a"}}};
  EXPECT_EQ(loadProgress(path, message), all);
  saveProgress(path, all, {});
  EXPECT_EQ(loadProgress(path, message), LessonProgress{});
  saveProgress(path, all, {{"plane", {"a", "b", "c", "d"}}, {"sphere", {"a"}}});  // one that still knows all
  EXPECT_EQ(loadProgress(path, message), (LessonProgress{{"plane", {"d"}}})) << "forgotten is forgotten";
}

TEST(ProgressFile, WhereItHasVanishedIsWrittenAsAWhole) {
  const TemporaryFolder folder;
  std::string message;
  saveProgress(folder / "state/progress.json", {{"plane", {"a"}}}, {{"plane", {"a", "b"}}});
  EXPECT_EQ(loadProgress(folder / "state/progress.json", message), (LessonProgress{{"plane", {"a", "b"}}}));
}

// Many windows at once, each of which does steps of its own.
TEST(ProgressFile, OfManyWindowsAtOnceLosesNoStep) {
  const TemporaryFolder folder;
  const std::string path = folder / "progress.json";
  constexpr int windows = 4, steps = 6;
  std::vector<std::thread> threads;
  for (int window = 0; window < windows; ++window) {
    threads.emplace_back([&path, window] {
      LessonProgress before, now;
      for (int step = 0; step < steps; ++step) {
        now["window " + std::to_string(window)].insert(std::to_string(step));
        saveProgress(path, before, now);
        before = now;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  std::string message;
  const LessonProgress all = loadProgress(path, message);
  EXPECT_EQ(all.size(), std::size_t{windows});
  for (const auto& [window, done] : all) EXPECT_EQ(done.size(), std::size_t{steps}) << window;
  EXPECT_EQ(folder.fileCount(), 1u) << "the lock has gone";
}

TEST(ProgressFile, WithoutOneNothingIsDone) {
  const TemporaryFolder folder;
  std::string message;
  EXPECT_TRUE(loadProgress(folder / "none.json", message).empty());
  EXPECT_EQ(message, "");
}

TEST(ProgressFile, AFolderThatCannotBeMadeIsAnError) {
  EXPECT_THROW(saveProgress("/dev/null/progress.json", {}, {}), Error);
}

}  // namespace
}  // namespace anamorph
