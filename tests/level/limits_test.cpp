#include "level/limits.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "level/level.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

TEST(Limits, HoldBothEndsAndNoNan) {
  constexpr Range range{1, 4};
  EXPECT_TRUE(range.holds(1) && range.holds(4));
  EXPECT_FALSE(range.holds(0.999) || range.holds(4.001) || range.holds(std::nan("")));
  EXPECT_TRUE(range.holds(Range{1, 4}) && range.holds(Range{2, 3}));
  EXPECT_FALSE(range.holds(Range{0, 3}) || range.holds(Range{2, 5}));
}

TEST(Limits, PanelsNeverOfferWhatALevelMayNotHold) {
  EXPECT_THROW(Limit({1, 2}, {0.5, 2}), const char*);  // as a constant it does not compile
  EXPECT_NO_THROW(Limit({1, 2}, {1.5, 2}));
}

TEST(Limits, TheDefaultsAreOffered) {
  const Level level;
  EXPECT_TRUE(limits::fieldOfView.panel.holds(level.camera.fovDegrees));
  EXPECT_TRUE(limits::viewFieldOfView.panel.holds(level.view.fovDegrees));
  EXPECT_TRUE(limits::depthScale.panel.holds(level.sculpture.depthScale));
  EXPECT_TRUE(limits::tolerance.panel.holds(level.sculpture.tolerancePixels));
  EXPECT_TRUE(limits::shininess.panel.holds(level.original.material.shininess));
  EXPECT_TRUE(limits::boxSegments.panel.holds(BoxShape{}.segments));
  EXPECT_TRUE(limits::sphereSegments.panel.holds(SphereShape{}.segments));
  EXPECT_TRUE(limits::knotSegments.panel.holds(TorusKnotShape{}.segments));
  EXPECT_TRUE(limits::knotSides.panel.holds(TorusKnotShape{}.sides));
  EXPECT_TRUE(limits::letterSegments.panel.holds(LetterFShape{}.segments));
  EXPECT_TRUE(limits::pawnSegments.panel.holds(PawnShape{}.segments));
  EXPECT_TRUE(limits::lightIntensity.panel.holds(PointLight{}.intensity));
  EXPECT_LE(level.lights.size(), limits::mostOfferedLights);
}

// Numbers where a range is meant: in rows of the panels, options of the commands, and fields of the level.
TEST(Limits, StandInTheTableAlone) {
  const std::regex literal(
      R"((number|slider|integer|vector)Row\(\s*"[^"]*",[^;"]*?\{?\s*-?[0-9.]+(e[-+]?[0-9]+)?\s*,\s*-?[0-9]|)"
      R"(numberIn\(\s*\{?\s*-?[0-9]|)"
      R"(NumberRange \w+\{\s*-?[0-9]|)"
      R"(\bRange\{\s*-?[0-9])");
  int seen = 0;
  for (const char* room : {"cli", "panels", "level"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(ANAMORPH_SOURCE_DIR) / "src" / room)) {
      if (entry.path().filename() == "limits.h") continue;
      std::ifstream file(entry.path());
      const std::string code{std::istreambuf_iterator<char>(file), {}};
      std::smatch match;
      EXPECT_FALSE(std::regex_search(code, match, literal)) << entry.path() << ": " << match.str();
      ++seen;
    }
  }
  EXPECT_GT(seen, 60);
}

}  // namespace
}  // namespace anamorph
