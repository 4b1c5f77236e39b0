#include "app/crash_handler.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "app/autosave.h"
#include "app/recovery_files.h"
#include "cli/program.h"
#include "level/level_json.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using namespace anamorph::testing;

// noinline, and with work after the call, so that it is not made a loop.
[[gnu::noinline]] int useUpStack(long bytes) {
  volatile char room[4096];
  room[0] = static_cast<char>(bytes);
  return bytes < 0 ? 0 : useUpStack(bytes - 4096) + room[0];
}

void raiseAs(int signal) {
  if (signal == SIGSEGV) std::exit(useUpStack(1L << 40));
  if (signal == SIGABRT) std::abort();
  ::raise(signal);
}

// A process that ends in `work`. Returns how, as waitpid() has it.
template <typename Work>
int endIn(const Work& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    std::_Exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

class CrashTest : public ::testing::Test {
 protected:
  CrashTest() { session.open(std::string(ANAMORPH_LEVELS) + "/1-plane.json"); }

  TemporaryFolder temporary;
  fs::path folder = temporary / "state";
  Session session;
};

class ACrash : public CrashTest, public ::testing::WithParamInterface<int> {};

TEST_P(ACrash, LeavesWhatWasChangedLastBeforeAnAutosaveIsDue) {
  const int status = endIn([&] {
    ::signal(GetParam(), SIG_DFL);  // instead of a sanitizer's
    installCrashHandler();
    Autosave autosave(folder);
    Level level = session.level();
    level.sculpture.depthScale = 0.5;
    session.edit(level);
    autosave.update(session, {}, 100);
    level.sculpture.depthScale = 0.75;
    session.edit(level);
    autosave.update(session, {}, 100.1);
    autosave.finish(20);
    raiseAs(GetParam());
  });
  ASSERT_TRUE(WIFSIGNALED(status)) << status;
  EXPECT_EQ(WTERMSIG(status), GetParam()) << "it ends as without the handler";
  const std::vector<Rescued> rescued = findRescued(folder);
  ASSERT_EQ(rescued.size(), 1u);
  EXPECT_EQ(rescued[0].entry.problem, "");
  EXPECT_EQ(rescued[0].level.sculpture.depthScale, 0.75);
}

INSTANTIATE_TEST_SUITE_P(Signals, ACrash,
                         ::testing::Values(SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL, SIGTERM, SIGHUP, SIGINT),
                         [](const auto& signal) { return std::string(::sigabbrev_np(signal.param)); });

using ACrashDuringADrag = CrashTest;

TEST_F(ACrashDuringADrag, LeavesAMomentBefore) {
  endIn([&] {
    installCrashHandler();
    Autosave autosave(folder);
    for (int frame = 0; frame <= 100; ++frame) {
      Level level = session.level();
      level.sculpture.depthScale = 0.5 + 0.001 * frame;
      session.change(level);
      autosave.update(session, {}, 100 + 0.02 * frame);
      autosave.finish(20);
    }
    std::abort();
  });
  const std::vector<Rescued> rescued = findRescued(folder);
  ASSERT_EQ(rescued.size(), 1u);
  EXPECT_GE(rescued[0].level.sculpture.depthScale, 0.549) << "a second before, not the beginning";
}

// What was not to end the program (nohup) does not.
TEST_F(CrashTest, IgnoredSignalsStayIgnored) {
  const int status = endIn([&] {
    ::signal(SIGHUP, SIG_IGN);
    installCrashHandler();
    ::raise(SIGHUP);
    std::_Exit(7);
  });
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

}  // namespace
}  // namespace anamorph
