// The JSON Schema of `anamorph schema`, held against levels by a validator that knows nothing of Anamorph: what the
// reader takes without a warning is valid, what it refuses is not.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "base/file.h"
#include "cannot_run_here.h"
#include "cli/program.h"
#include "error_text.h"
#include "level/level_json.h"
#include "level/level_library.h"
#include "level/random_level.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using testing::readAll;
using testing::TemporaryFolder;

class LevelSchema : public ::testing::Test {
 protected:
  void SetUp() override {
    writeFile(folder_ / "schema.json", formatLevelSchema());
    if (std::system("python3 -c 'import jsonschema' 2>/dev/null") != 0) {
      cannotRunHere("the package python3-jsonschema is not installed");
    }
  }

  // For each text what the validator says: "valid", or what is wrong.
  std::vector<std::string> validate(const std::vector<std::string>& texts) {
    std::string command =
        "python3 " ANAMORPH_SOURCE_DIR "/tests/level/validate.py " + (folder_ / "schema.json");
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const std::string file = folder_ / (std::to_string(i) + ".json");
      writeFile(file, texts[i]);
      command += " " + file;
    }
    const std::string said = folder_ / "said";
    EXPECT_EQ(std::system((command + " >" + said + " 2>&1").c_str()), 0) << readAll(said);
    std::istringstream lines(readAll(said));
    std::vector<std::string> all;
    for (std::string line; std::getline(lines, line);) all.push_back(line);
    EXPECT_EQ(all.size(), texts.size());
    all.resize(texts.size());
    return all;
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(LevelSchema, HoldsForEveryLevelThatThereIs) {
  std::vector<std::string> texts, names;
  for (const fs::path& folder : {fs::path(ANAMORPH_LEVELS), fs::path(ANAMORPH_TEST_DATA) / "levels"}) {
    for (const LevelEntry& entry : listLevels(folder)) {
      names.push_back(entry.name);
      texts.push_back(readAll(entry.path));
    }
  }
  const std::vector<std::string> said = validate(texts);
  ASSERT_GE(said.size(), 9u);
  for (std::size_t i = 0; i < said.size(); ++i) EXPECT_EQ(said[i], "valid") << names[i];
}

TEST_F(LevelSchema, HoldsForWhateverIsSaved) {
  std::vector<std::string> texts;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Level level = RandomLevel(seed).make();
    level.text.edit([](LevelText& text) { text.unknownKeys.clear(); });
    texts.push_back(formatLevel(level));
  }
  const std::vector<std::string> said = validate(texts);
  for (std::size_t i = 0; i < said.size(); ++i)
    EXPECT_EQ(said[i], "valid") << "seed " << i << "\n" << texts[i];
}

// Every pair: a piece of the level that has every field, and what makes it wrong.
TEST_F(LevelSchema, DoesNotHoldForBadFiles) {
  const std::vector<std::pair<std::string, std::string>> changes{
      {"anamorph-level", "gltf"},
      {"\"version\": 2", "\"version\": 0"},
      {"\"version\": 2", "\"version\": 1.5"},
      {"\"level.schema.json\"", "7"},
      {"\"title\"", "\"titel\""},
      {"\"optic\"", "\"optics\""},
      {"\"mirror\"", "\"glass\""},
      {"\"type\": \"cylinder\"", "\"type\": \"egg\""},
      {"\"type\": \"cylinder\"", "\"type\": \"sphere\""},
      {"\"radius\": 7", "\"radius\": -7"},
      {"\"radius\": 7", "\"raduis\": 7"},
      {"\"bottom\": [1, 2, 3]", "\"bottom\": [1, 2]"},
      {"\"bottom\": [1, 2, 3]", "\"bottom\": [1, 2, \"3\"]"},
      {"\"eye\": [1, -12, 8]", "\"eye\": [1, -12, 8e9]"},
      {"\"grid\": [9, 7]", "\"grid\": [9, 700]"},
      {"\"segments\": 100", "\"segments\": 1"},
      {"\"segments\": 100", "\"segments\": 10.5"},
      {"\"torusKnot\"", "\"donut\""},
      {"\"scale\": [1, 2, 3]", "\"scale\": \"big\""},
      {"\"unitize\": true", "\"unitize\": 1"},
      {"\"off\"", "\"on\""},
      {"\"off\"", "-1"},
      {"\"lights\": [", "\"lights\": [5, "},
      {"\"lights\": [", "\"lights\": [{}, "},
      {"\"movedEye\"", "\"jumped\""},
      {"\"movedEye\"", "\"matchAbove\""},
      {"\"movedEye\"", "\"movedEye\", \"value\": 1"},
      {"\"movedEye\"", "\"viewed\", \"what\": \"cat\""},
      {"\"why\"", "\"whi\""},
      {"\"id\": \"eye\",", ""}};
  const std::string base = readAll(fs::path(ANAMORPH_TEST_DATA) / "levels" / "every-field.json");
  std::vector<std::string> texts;
  for (const auto& [from, to] : changes) {
    const std::size_t place = base.find(from);
    ASSERT_NE(place, std::string::npos) << from;
    texts.push_back(std::string(base).replace(place, from.size(), to));
  }
  const std::vector<std::string> said = validate(texts);
  for (std::size_t i = 0; i < said.size(); ++i) {
    EXPECT_NE(said[i], "valid") << changes[i].first << " -> " << changes[i].second;
    std::vector<std::string> warnings;
    const std::string error = errorOf([&] { warnings = parseLevel(texts[i], "l.json").warnings; });
    EXPECT_TRUE(error != "no error" || !warnings.empty()) << changes[i].first << " -> " << changes[i].second;
  }
}

}  // namespace
}  // namespace anamorph
