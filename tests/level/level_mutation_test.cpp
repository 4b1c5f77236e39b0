// The fuzzer's property over its corpus and some thousand changed copies of it, the same ones each time.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "base/file.h"
#include "fuzz/level_fuzz.cpp"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> corpus() {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::directory_iterator(fs::path(ANAMORPH_SOURCE_DIR) / "tests" / "fuzz" / "corpus" / "level")) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> texts;
  for (const fs::path& file : files) texts.emplace_back(readFile(file, maxLevelBytes).view());
  return texts;
}

int run(const std::string& text) {
  return LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

// Replaces, removes or repeats a few bytes, or puts a telling piece of JSON in their place.
std::string mutated(std::string text, std::mt19937& random) {
  const char* pieces[] = {"1e999", "-0.0", "1e-300", "null", "{}",      "[]",   "\"\"",
                          ",",     "}",    "]",      "\"",   "\\u0000", "\xFF", "off"};
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  for (std::size_t changes = 1 + below(3); changes > 0 && !text.empty(); --changes) {
    const std::size_t place = below(text.size()), length = std::min(text.size() - place, below(8));
    switch (below(4)) {
      case 0:
        text[place] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(place, length);
        break;
      case 2:
        text.insert(place, text.substr(below(text.size()), length));
        break;
      default:
        text.replace(place, length, pieces[below(std::size(pieces))]);
    }
  }
  return text;
}

TEST(LevelMutations, CorpusIsReadOrRefused) {
  const std::vector<std::string> texts = corpus();
  ASSERT_GE(texts.size(), 5u);
  for (const std::string& text : texts) EXPECT_EQ(run(text), 0);
}

TEST(LevelMutations, ChangedCopiesAreReadOrRefused) {
  const std::vector<std::string> texts = corpus();
  std::mt19937 random(2024);
  for (int i = 0; i < 5000; ++i) {
    const std::string text = mutated(texts[static_cast<std::size_t>(i) % texts.size()], random);
    ASSERT_NO_THROW(run(text)) << "mutation " << i << "\n" << text;
  }
}

}  // namespace
}  // namespace anamorph
