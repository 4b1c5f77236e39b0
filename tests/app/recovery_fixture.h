// What tests of unsaved changes share: levels to tell apart, windows that die.
#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "app/autosave.h"
#include "cli/program.h"

namespace anamorph::testing {

inline Level numbered(int number) {
  Level level;
  level.text.edit([&](LevelText& text) { text.title = "Number " + std::to_string(number); });
  level.sculpture.depthScale = 1 + number % 50;
  return level;
}

class RecoveryTest : public ::testing::Test {
 protected:
  std::vector<std::filesystem::path> kept() const {
    std::vector<std::filesystem::path> paths;
    std::error_code none;
    for (std::filesystem::directory_iterator entry(folder, none), end; !none && entry != end;
         entry.increment(none)) {
      if (entry->path().extension() == ".json") paths.push_back(entry->path());
    }
    return paths;
  }
  std::size_t files() const { return kept().size(); }
  /// Of the level in the only file.
  std::string keptTitle() const {
    const std::string text = readAll(kept().at(0)), before = "\"title\": \"";
    const std::size_t begin = text.find(before) + before.size();
    return text.substr(begin, text.find('"', begin) - begin);
  }
  /// What becomes of a process that does this, and is killed then.
  template <typename Work>
  static void dieWith(const Work& work) {
    const pid_t child = ::fork();
    if (child == 0) {
      work();
      ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
  }
  /// A window that opens a file, or has a new level; changes it to `level`, keeps it and dies. `change` comes before it
  /// keeps it.
  template <typename Change>
  void die(const Level& level, const std::filesystem::path& path, const Change& change) const {
    dieWith([&] {
      Session other;
      path.empty() ? other.startNew(numbered(0)) : other.open(path);
      other.edit(level);
      change(other);
      Autosave& autosave = *new Autosave(folder);  // its destructor would end it as it should
      for (const double now : {100.0, 110.0}) autosave.update(other, {}, now);
      autosave.finish(20);
    });
  }
  void die(const Level& level, const std::filesystem::path& path = {}) const {
    die(level, path, [](Session&) {});
  }
  /// How many another window would offer that starts now.
  int offeredElsewhere() const {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(static_cast<int>(findRescued(folder).size()));
    int status = 0;
    ::waitpid(child, &status, 0);
    return WEXITSTATUS(status);
  }

  TemporaryFolder temporary;
  std::filesystem::path folder = temporary / "state/anamorph";
};

}  // namespace anamorph::testing
