// The seeds of the fuzz targets, and mutations of them, through the same checks in an ordinary test.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

#include "fuzz/mesh_fuzz.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using testing::readsAsMesh;

struct Seed {
  std::string name, bytes;
};

// In the order of their names, so that every run makes the same mutations.
std::vector<Seed> seedsOf(const std::string& format) {
  std::vector<Seed> seeds;
  for (const auto& entry : fs::directory_iterator(fs::path(ANAMORPH_TEST_DATA) / "../fuzz/corpus" / format)) {
    std::ifstream stream(entry.path(), std::ios::binary);
    seeds.push_back({entry.path().filename().string(), {std::istreambuf_iterator<char>(stream), {}}});
  }
  std::sort(seeds.begin(), seeds.end(), [](const Seed& a, const Seed& b) { return a.name < b.name; });
  return seeds;
}

class Mutator {
 public:
  Mutator(const std::vector<Seed>& seeds, unsigned seed) : seeds_(seeds), random_(seed) {}

  std::string next() {
    std::string bytes = pick().bytes;
    for (std::size_t changes = 1 + below(2); changes > 0; --changes) change(bytes);
    return bytes;
  }

 private:
  void change(std::string& bytes) {
    static const std::string words[] = {
        " nan ", "1e999", "-1", "0", "4294967297", "\n", " ",     "/",  "\\\n", "\xff\xff\xff\x7f",
        "f ",    "v ",    "9",  "#", "\r",         "1e", "solid", "-0", "3 ",   "\xEF\xBB\xBF"};
    const std::size_t at = below(bytes.size() + 1),
                      length = below(std::min<std::size_t>(bytes.size() - at, 30) + 1);
    switch (below(10)) {  // single bytes most often: they leave most of the file sound
      case 0:
        bytes.insert(at, words[below(std::size(words))]);
        break;
      case 1:
        bytes.erase(at, length);
        break;
      case 2:
        bytes.resize(at);
        break;
      case 3:
        bytes.insert(below(bytes.size() + 1), bytes.substr(at, length));
        break;
      case 4:
        bytes = bytes.substr(0, at) + pick().bytes.substr(0, below(300));
        break;
      default:
        if (at < bytes.size()) bytes[at] = static_cast<char>(below(256));
    }
  }

  std::size_t below(std::size_t count) { return random_() % count; }
  const Seed& pick() { return seeds_[below(seeds_.size())]; }

  const std::vector<Seed>& seeds_;
  std::mt19937 random_;
};

class FuzzCorpus : public ::testing::TestWithParam<const char*> {};

TEST_P(FuzzCorpus, SeedsAreGoodOrBadAsTheirNamesSay) {
  const auto seeds = seedsOf(GetParam());
  EXPECT_GE(seeds.size(), 7u);
  for (const Seed& seed : seeds)
    EXPECT_EQ(readsAsMesh(seed.bytes, seed.name), seed.name.starts_with("good_")) << seed.name;
}

TEST_P(FuzzCorpus, MutationsAreMeshesOrErrors) {
  const auto seeds = seedsOf(GetParam());
  const std::string name = std::string("mutation.") + GetParam();
  const unsigned randomSeed = 3;
  Mutator mutator(seeds, randomSeed);
  int meshes = 0;
  for (int i = 0; i < 4000; ++i) {
    EXPECT_NO_THROW(meshes += readsAsMesh(mutator.next(), name))
        << "mutation " << i << " of seed " << randomSeed;
  }
  // Were all of them refused at once, nothing would be tested.
  EXPECT_GT(meshes, 100) << meshes;
  EXPECT_LT(meshes, 3800);
}

INSTANTIATE_TEST_SUITE_P(Formats, FuzzCorpus, ::testing::Values("obj", "stl", "ply"),
                         [](const auto& format) { return std::string(format.param); });

}  // namespace
}  // namespace anamorph
