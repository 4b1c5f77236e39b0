#include "math/color.h"

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "math/palette.h"

namespace anamorph {
namespace {

TEST(Colors, InkIsWhatTheHexadecimalNumberSays) {
  static_assert(inkOf(Rgb{0xFF8000}) == Color(1, 128 / 255.0, 0));
  static_assert(channelOf(palette::vermilion, 0) == 0xD5 && channelOf(palette::vermilion, 1) == 0x5E &&
                channelOf(palette::vermilion, 2) == 0);
}

TEST(Colors, TheCurveGoesBothWays) {
  for (int byte = 0; byte <= 255; ++byte) {
    EXPECT_NEAR(displayOf(lightOf(byte / 255.0)), byte / 255.0, 1e-7) << byte;
  }
  EXPECT_EQ(lightOf(Rgb{0x000000}), Color(0));
  EXPECT_NEAR(lightOf(Rgb{0xFFFFFF}).x, 1, 1e-12);
  EXPECT_NEAR(lightOf(palette::green).y, 0.342, 1e-3);
}

TEST(Palette, KindsThatAreShownTogetherDiffer) {
  const auto differ = [](const auto& colors) {
    for (std::size_t i = 0; i < colors.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) EXPECT_NE(colors[i], colors[j]) << i << ", " << j;
    }
  };
  using namespace palette;
  differ(std::array{rayFromEye, rayReflected, rayToLight, rayInShadow, rayIntoSky, normal, virtualRay});
  differ(std::array{onlyOriginal, onlyReflection, hiddenReflection, noMirror});
  differ(vertexStatus);
  differ(viewAxes);
  differ(fieldAxes);
}

// Black, white and grey only make lighter and darker; the themes' own colours are a table in style.cpp.
TEST(Palette, IsTheOnlyPlaceOfColours) {
  namespace fs = std::filesystem;
  const std::regex drawn(R"(IM_COL32\(\s*(\w+),\s*(\w+),\s*(\w+))"), number(R"(0x[0-9A-Fa-f]{6}\b)");
  int seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ANAMORPH_SOURCE_DIR) / "src")) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_regular_file() || name == "palette.h" || name == "style.cpp") continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      std::smatch match;
      EXPECT_FALSE(std::regex_search(line, match, number)) << entry.path() << ": " << line;
      if (!std::regex_search(line, match, drawn)) continue;
      EXPECT_TRUE(match[1] == match[2] && match[2] == match[3]) << entry.path() << ": " << line;
      ++seen;
    }
  }
  EXPECT_GT(seen, 5);
}

}  // namespace
}  // namespace anamorph
