// The commands on a level whose sculpture is frozen: the same sculpture and figures as in the window.

#include "level/freeze.h"

#include <gtest/gtest.h>

#include <string>

#include "cli/program.h"
#include "level/json.h"
#include "level/level_json.h"
#include "pipeline/evaluator.h"

namespace anamorph {
namespace {

using namespace testing;

class FrozenFile : public ::testing::Test {
 protected:
  FrozenFile() {
    level_ = loadLevel(std::filesystem::path(ANAMORPH_LEVELS) / "2-cylinder.json").level;
    std::get<BoxShape>(level_.original.shape).segments = 4;
    level_.text.edit([](LevelText& text) { text.lesson.clear(); });  // it picks vertices that the box has not
    saveLevel(folder_ / "before.json", level_);
    level_ = frozen(level_);
    level_.camera.eye.x += 3;
    level_.original.placement.position.z += 0.5;
    level_.original.placement.rotationDegrees.z += 20;
    saveLevel(file_, level_);
  }

  TemporaryFolder folder_;
  std::string file_ = folder_ / "frozen.json";
  Level level_;
};

TEST_F(FrozenFile, GivesTheSculptureAsItWas) {
  const std::string before = folder_ / "before.obj", after = folder_ / "after.obj";
  ASSERT_EQ(run("deform " + (folder_ / "before.json") + " -o " + before).exitCode, 0);
  const Result frozen = run("deform " + file_ + " -o " + after);
  ASSERT_EQ(frozen.exitCode, 0) << frozen.err;
  EXPECT_EQ(readAll(before), readAll(after));
  EXPECT_NE(frozen.err.find("warning: the sculpture is frozen as it was made for the eye at (0, -9.1, 9.6)"),
            std::string::npos)
      << frozen.err;
  ASSERT_EQ(run("export " + (folder_ / "before.json") + " -o " + (folder_ / "before.stl")).exitCode, 0);
  ASSERT_EQ(run("export " + file_ + " -o " + (folder_ / "after.stl")).exitCode, 0);
  EXPECT_EQ(readAll(folder_ / "before.stl"), readAll(folder_ / "after.stl"));
  ASSERT_EQ(run("export " + (folder_ / "before.json") + " -o " + (folder_ / "before.svg")).exitCode, 0);
  const Result sheet = run("export " + file_ + " -o " + (folder_ / "after.svg"));
  EXPECT_EQ(readAll(folder_ / "before.svg"), readAll(folder_ / "after.svg"));
  EXPECT_NE(sheet.err.find("where they were when the sculpture was frozen"), std::string::npos) << sheet.err;
}

TEST_F(FrozenFile, IsMatchedAndRenderedAsInTheWindow) {
  const LevelResult window = *Evaluator().evaluate({level_, file_, 64}, 2);
  const Result match = run("match " + file_ + " --json");
  ASSERT_EQ(match.exitCode, 0) << match.err;
  const JsonValue report = parseJson(match.out, "match");
  const auto figure = [&](const char* key) { return findMember(report, key)->number; };
  EXPECT_NEAR(figure("silhouetteIou"), window.match->report.silhouetteIou, 1e-12);
  EXPECT_NEAR(figure("contourPx"), window.match->report.contourPx, 1e-12);
  EXPECT_NEAR(figure("extraShare"), window.match->report.extraShare, 1e-12);
  EXPECT_LT(figure("silhouetteIou"), 0.9);
  for (const std::string view : {"reflection", "original", "difference"})
    EXPECT_EQ(run("render " + file_ + " --view " + view + " --size 32x32 -o " + (folder_ / "a.png")).exitCode,
              0);
  const Result check = run("check " + file_);
  EXPECT_EQ(check.exitCode, 0);
  EXPECT_NE(check.err.find("the sculpture is frozen"), std::string::npos) << check.err;
}

TEST_F(FrozenFile, RaysAndReportAreThoseItWasMadeBy) {
  const std::string before = folder_ / "before-rays.obj", after = folder_ / "after-rays.obj";
  ASSERT_EQ(run("export " + (folder_ / "before.json") + " --rays vertices:20 -o " + before).exitCode, 0);
  ASSERT_EQ(run("export " + file_ + " --rays vertices:20 -o " + after).exitCode, 0);
  EXPECT_EQ(readAll(before), readAll(after));
  level_.sculpture.depthScale = 0.75;
  saveLevel(file_, level_);
  ASSERT_EQ(run("export " + file_ + " -o " + (folder_ / "m.html")).exitCode, 0);
  const std::string page = readAll(folder_ / "m.html");
  EXPECT_NE(page.find("depth scale 0.25"), std::string::npos) << "not the one that is to come";
  EXPECT_NE(page.find("the sculpture is frozen"), std::string::npos);
}

TEST_F(FrozenFile, IsNotChangedByOptions) {
  for (const std::string option : {"--depth-scale 0.5", "--unitize"}) {
    const Result result = run("match " + file_ + " " + option);
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.err.find("its sculpture is frozen, and " + option.substr(0, option.find(' ')) +
                              " would change it"),
              std::string::npos)
        << result.err;
  }
  EXPECT_EQ(run("match " + file_ + " --tolerance 1").exitCode, 0) << "how fine it is may change";
}

TEST_F(FrozenFile, FollowsAgainWithAnotherOriginal) {
  const std::string cube = std::string(ANAMORPH_TEST_DATA) + "/meshes/cube.obj";
  const Result result = run("match " + file_ + " " + cube);
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_NE(result.err.find("with another original it follows again"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("excellent"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace anamorph
