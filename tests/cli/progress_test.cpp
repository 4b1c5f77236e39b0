// The progress bar, on a terminal of its own (util-linux' `script` gives one); without one it cannot run.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cannot_run_here.h"
#include "program.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(ProgressBar, ShowsOnATerminalForWhatTakesLongAndGoesAway) {
  if (std::system("script -qec true /dev/null >/dev/null 2>&1") != 0)
    return cannotRunHere("no pseudo-terminal");
  const TemporaryFolder folder;
  const std::string render = std::string(ANAMORPH_PROGRAM) +
                             " render 2-cylinder --size 450x450 --samples 4 --threads 1 -o " +
                             (folder / "p.png");
  const auto onTerminal = [&](const std::string& command) {
    const int status =
        std::system(("script -qec '" + command + "' " + (folder / "typescript") + " >/dev/null").c_str());
    EXPECT_EQ(status, 0);
    return readAll(folder / "typescript");
  };
  const std::string shown = onTerminal(render);
  EXPECT_THAT(shown, HasSubstr("rendering ["));
  EXPECT_THAT(shown, HasSubstr(" %"));
  EXPECT_THAT(onTerminal(render + " --quiet"), Not(HasSubstr("rendering [")));
  EXPECT_THAT(run("render 2-cylinder --size 300x300 --samples 4 --threads 1 -o " + (folder / "q.png")).err,
              Not(HasSubstr("rendering [")))
      << "not a terminal";
}

}  // namespace
}  // namespace anamorph
