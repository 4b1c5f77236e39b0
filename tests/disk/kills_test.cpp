// Programs that are killed while they save: at any moment the old document or the new one is there, and what could be
// tidied up is. More moments: --gtest_repeat (./test.sh --all does).

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "base/file.h"
#include "base/temporary_file.h"
#include "cli/program.h"
#include "error_text.h"
#include "level/level_json.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using namespace testing;
using std::chrono::microseconds;
using std::chrono::steady_clock;

// Those in the folder that have begun to be written.
std::vector<fs::path> temporaries(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code gone;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!entry.path().filename().string().starts_with(".anamorph-")) continue;
    if (entry.file_size(gone) > 0 && !gone) found.push_back(entry.path());
  }
  return found;
}

template <typename Work>
pid_t inAChild(const Work& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::_exit(0);
  }
  return child;
}

int statusOf(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

Level numbered(int number, std::size_t size) {
  Level level;
  level.text.edit([&](LevelText& text) {
    text.title = "Number " + std::to_string(number);
    text.description = std::string(size, 'x');
  });
  return level;
}

TEST(Killed, AtAnyMomentOfASaveTheOldOrTheNewLevelIsThere) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> delay(0, 20000);  // microseconds: some saves long
  const TemporaryFolder folder;
  const fs::path path = folder / "level.json";
  const Level levels[] = {numbered(1, 60000), numbered(2, 10)};
  saveLevel(path, levels[0]);
  for (int moment = 0; moment < 10; ++moment) {
    const pid_t child = inAChild([&] {
      for (int i = moment;; ++i) saveLevel(path, levels[i % 2]);
    });
    const int waited = delay(random);
    std::this_thread::sleep_for(microseconds(waited));
    ::kill(child, SIGKILL);
    ASSERT_TRUE(WIFSIGNALED(statusOf(child))) << "it was killed, it did not fail";
    const Level found = loadLevel(path).level;
    ASSERT_TRUE(found == levels[0] || found == levels[1]) << "killed after " << waited << " us";
  }
}

TEST(Terminated, ASaveLeavesNothingBehindAndDiesOfItsSignal) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const TemporaryFolder folder;
    writeFile(folder / "doc", "old");
    const pid_t child = inAChild([&] {
      ::signal(signal, SIG_DFL);  // whoever runs the tests may have it ignored
      removeTemporariesOnSignals();
      AtomicFile first(folder / "doc"), second(folder / "other");
      first.write("new");
      ::raise(signal);
    });
    const int status = statusOf(child);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), signal);
    EXPECT_EQ(folder.fileCount(), 1u);
    EXPECT_EQ(readAll(folder / "doc"), "old");
  }
}

TEST(Terminated, ASignalThatIsIgnoredStaysSo) {
  const TemporaryFolder folder;
  const pid_t child = inAChild([&] {
    ::signal(SIGHUP, SIG_IGN);  // as nohup does
    removeTemporariesOnSignals();
    AtomicFile file(folder / "doc");
    ::raise(SIGHUP);
    file.write("new");
    file.commit();
  });
  EXPECT_EQ(statusOf(child), 0);
  EXPECT_EQ(readAll(folder / "doc"), "new");
}

TEST(Terminated, AFileThatGrowsBeyondWhatIsAllowedIsAnErrorInstead) {
  const TemporaryFolder folder;
  const pid_t child = inAChild([&] {
    removeTemporariesOnSignals();
    const rlimit small{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &small);
    const std::string error = errorOf([&] { writeFile(folder / "doc", std::string(5000, 'x')); });
    ::_exit(error == (folder / "doc") + ": cannot write: File too large" ? 7 : 1);
  });
  EXPECT_EQ(WEXITSTATUS(statusOf(child)), 7);
  EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(Terminated, ACommandLeavesItsOldOutputAndNothingElse) {
  int caught = 0;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const TemporaryFolder folder;
    const std::string output = folder / "sculpture.obj";
    writeText(output, "old");
    const pid_t child = inAChild([&] {
      ::signal(signal, SIG_DFL);
      ::close(2);
      ::execl(ANAMORPH_PROGRAM, "anamorph", "deform", "3-sphere", "--tolerance", "0.002", "-o",
              output.c_str(), nullptr);
      ::_exit(127);
    });
    int status = 0;
    const auto end = steady_clock::now() + std::chrono::seconds(60);
    bool ended = false, writing = false;
    while (!writing && !ended && steady_clock::now() < end) {
      writing = !temporaries(folder / "").empty();
      ended = ::waitpid(child, &status, WNOHANG) == child;
    }
    if (!ended) {
      ::kill(child, signal);
      ::waitpid(child, &status, 0);
    }
    EXPECT_EQ(folder.fileCount(), 1u) << "no temporary";
    const bool signalled = WIFSIGNALED(status) && WTERMSIG(status) == signal;
    EXPECT_TRUE(signalled || status == 0) << status;
    EXPECT_EQ(readAll(output) == "old", signalled) << "else it was quicker";
    caught += signalled && writing;
  }
  EXPECT_GT(caught, 0) << "none was caught while it wrote";
}

}  // namespace
}  // namespace anamorph
