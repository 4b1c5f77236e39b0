// The fuzzer's property over the program's levels, changed copies of them, and random ones, the same ones each time.

#include "fuzz/level_journey.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "level/random_level.h"

namespace anamorph::testing {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> textsIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> texts;
  for (const fs::path& file : files) texts.push_back(readAll(file));
  return texts;
}

// One to three of its numbers become others: the ends of ranges, nothing, and those just beside.
std::string withOtherNumbers(std::string text, std::mt19937& random) {
  const char* const numbers[] = {"0",    "-0.0", "1",    "-1",      "0.5",  "1e-6", "-1e-6", "1e6",
                                 "-1e6", "2",    "1e-9", "0.01",    "100",  "3",    "-20",   "1000",
                                 "170",  "8",    "64",   "0.99999", "89.9", "-3.4", "16384", "1e-300"};
  const auto below = [&](std::size_t count) { return random() % count; };
  const auto isOfNumber = [](char c) {
    return std::isdigit(static_cast<unsigned char>(c)) || c == '-' || c == '.';
  };
  for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
    std::size_t begin = text.find_first_of("0123456789", below(text.size()));
    if (begin == std::string::npos) continue;
    while (begin > 0 && isOfNumber(text[begin - 1])) --begin;
    std::size_t end = begin;
    while (end < text.size() && isOfNumber(text[end])) ++end;
    text.replace(begin, end - begin, numbers[below(std::size(numbers))]);
  }
  return text;
}

TEST(LevelJourney, TheProgramsLevelsArrive) {
  const TemporaryFolder folder;
  for (const std::string& text : textsIn(ANAMORPH_LEVELS)) {
    const Journey journey = journeyOf(text, folder / "");
    EXPECT_TRUE(journey.read && journey.hasSculpture) << text.substr(0, 200);
    EXPECT_GE(journey.exports, 8u) << text.substr(0, 200);
  }
}

TEST(LevelJourney, TheCorpusArrivesOrIsRefused) {
  const TemporaryFolder folder;
  for (const std::string& text : textsIn(fs::path(ANAMORPH_SOURCE_DIR) / "tests/fuzz/corpus/level"))
    EXPECT_NO_THROW(journeyOf(text, folder / "")) << text;
}

TEST(LevelJourney, ChangedLevelsArriveOrAreRefused) {
  const TemporaryFolder folder;
  const std::vector<std::string> texts = textsIn(ANAMORPH_LEVELS);
  constexpr unsigned seed = 5;
  std::mt19937 random(seed);
  int read = 0, sculptures = 0;
  for (int i = 0; i < 120; ++i) {
    const std::string text = withOtherNumbers(texts[static_cast<std::size_t>(i) % texts.size()], random);
    Journey journey;
    ASSERT_NO_THROW(journey = journeyOf(text, folder / "")) << "seed " << seed << ", change " << i << "\n"
                                                            << text;
    read += journey.read;
    sculptures += journey.hasSculpture;
  }
  // Were most of them refused, little would be tested.
  EXPECT_GT(read, 60);
  EXPECT_GT(sculptures, 30);
}

TEST(LevelJourney, RandomLevelsArriveOrAreRefused) {
  const TemporaryFolder folder;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    const Level level = RandomLevel(seed).make();
    ASSERT_NO_THROW(journeyOf(formatLevel(level), folder / "")) << "seed " << seed << "\n"
                                                                << formatLevel(level);
  }
}

}  // namespace
}  // namespace anamorph::testing
