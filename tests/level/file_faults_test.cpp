// A file's faults are told all at once, with their places, and with what was meant.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "cli/program.h"
#include "level/level_json.h"

namespace anamorph {
namespace {

std::vector<std::string> faultsOf(const std::string& text) {
  try {
    parseLevel(text, "l.json");
  } catch (const Error& error) {
    return linesOf(error);
  }
  return {};
}

TEST(FileFaults, AreToldAllAtOnceInTheOrderOfTheFile) {
  const std::string text = R"({
  "format": "anamorph-level", "version": 1,
  "optic": {"kind": "miror", "shape": {"type": "cilinder", "bottom": [0, 0], "top": [0, 0, 9], "raduis": 3}},
  "camera": {"eye": [0, -13, "9"], "target": [0, 5, 1], "fovDegrees": 200},
  "original": {"shape": {"type": "torusknot", "p": 2, "q": 4, "segments": 1}, "placement": {"scale": "big"}},
  "lights": [{"position": [1, 2, 3]}, {"intensity": -1}, 7],
  "lesson": {"id": "", "steps": [
    {"id": "a", "title": "T", "why": "W", "do": "D", "figure": "edge", "done": [{"when": "movedeye"}]},
    {"id": "a", "titel": "T", "why": "é", "do": 5, "done": [{"when": "matchAbove", "vlaue": 0.5}, {"when": "gone"}]}
  ]}
})";
  const std::vector<std::string> expected{
      "line 3, column 21: /optic/kind: expected \"mirror\" or \"none\", got \"miror\"; did you mean "
      "\"mirror\"?",
      "line 3, column 39: /optic/shape: expected the key \"radius\", got an object without it",
      "line 3, column 48: /optic/shape/type: expected \"plane\", \"cylinder\", \"sphere\", \"cone\", "
      "\"ellipsoid\", \"paraboloid\", \"revolution\", \"extrusion\", \"patch\" or \"mesh\", got "
      "\"cilinder\"; did you mean \"cylinder\"?",
      "line 3, column 70: /optic/shape/bottom: expected an array of 3 numbers, got [0, 0]",
      "line 4, column 30: /camera/eye/2: expected a number from -1000000 to 1000000, got \"9\"",
      "line 4, column 71: /camera/fovDegrees: expected a number from 1 to 170, got 200",
      "line 5, column 34: /original/shape/type: expected \"box\", \"sphere\", \"torusKnot\", \"letterF\", "
      "\"pawn\" or "
      "\"file\", got \"torusknot\"; did you mean \"torusKnot\"?",
      "line 5, column 60: /original/shape/q: expected a number without a common divisor with p, got 4",
      "line 5, column 75: /original/shape/segments: expected a whole number from 3 to 4096, got 1",
      "line 5, column 102: /original/placement/scale: expected a number or an array of 3 numbers, got "
      "\"big\"",
      "line 6, column 39: /lights/1: expected the key \"position\", got an object without it",
      "line 6, column 53: /lights/1/intensity: expected a number from 0 to 1000, got -1",
      "line 6, column 58: /lights/2: expected an object, got 7",
      "line 7, column 20: /lesson/id: expected a name that is not empty, got \"\"",
      "line 8, column 64: /lesson/steps/0/figure: expected \"perspective\", \"construction\", \"columns\", "
      "\"edges\" or "
      "\"occlusion\", got \"edge\"; did you mean \"edges\"?"};
  const std::vector<std::string> faults = faultsOf(text);
  ASSERT_EQ(faults.size(), expected.size() + 8);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(faults[i], "l.json: " + expected[i]);
  const std::vector<std::string> ends{
      "; did you mean \"movedEye\"?",
      "line 9, column 5: /lesson/steps/1: expected the key \"title\", got an object without it",
      "line 9, column 12: /lesson/steps/1/id: expected an id of its own, got \"a\" again",
      "line 9, column 17: /lesson/steps/1/titel: expected a key that is known here, got \"titel\"; did you "
      "mean "
      "\"title\"?",
      "line 9, column 49: /lesson/steps/1/do: expected a string, got 5",
      "/lesson/steps/1/done/0: expected the key \"value\", got an object without it",
      "/lesson/steps/1/done/0/vlaue: expected a key that is known here, got \"vlaue\"; did you mean "
      "\"value\"?",
      "got \"gone\""};
  for (std::size_t i = 0; i < ends.size() && expected.size() + i < faults.size(); ++i) {
    EXPECT_TRUE(faults[expected.size() + i].ends_with(ends[i])) << faults[expected.size() + i];
  }
}

TEST(FileFaults, ReadAsTheFirstOfThem) {
  try {
    parseLevel(R"({"format": "anamorph-level", "version": 1, "optic": 1, "camera": 2, "original": 3})",
               "l.json");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "l.json: line 1, column 53: /optic: expected an object, got 1 (and 2 more)");
    EXPECT_EQ(error.where, "line 1, column 53: /optic");
    EXPECT_EQ(error.faults.size(), 3u);
  }
}

TEST(FileFaults, ACommaTooManyHidesNoOther) {
  const auto faults = faultsOf(
      "{\"format\": \"anamorph-level\", \"version\": 1, \"optic\": 1,\n \"camera\": [2, ], \"original\": "
      "3,\n}");
  ASSERT_EQ(faults.size(), 5u);
  EXPECT_TRUE(faults[0].find("/optic") != std::string::npos) << faults[0];
  EXPECT_TRUE(faults[2].starts_with("l.json: line 2, column 14: expected another value after this comma"))
      << faults[2];
  EXPECT_TRUE(faults[4].starts_with("l.json: line 2, column 32: expected another value after this comma"))
      << faults[4];
}

TEST(FileFaults, AnotherVersionIsAllThatIsSaid) {
  EXPECT_EQ(faultsOf(R"({"format": "anamorph-level", "version": 9, "optic": 1})").size(), 1u);
}

TEST(FileFaults, OfAnUnknownKindNothingMoreIsSaid) {
  const std::vector<std::string> faults = faultsOf(R"({"format": "anamorph-level", "version": 1,
    "optic": {"kind": "none", "shape": {"type": "egg", "size": -1, "colour": "white"}},
    "camera": {"eye": [0, -9, 3], "target": [0, 5, 1]}, "original": {"shape": {"type": "box"}}})");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].find("/optic/shape/type"), std::string::npos);
}

TEST(FileFaults, UnknownKeysSayWhatWasMeant) {
  const LoadedLevel loaded = parseLevel(R"({"format": "anamorph-level", "version": 1, "$schema": "s.json",
    "optic": {"kind": "none", "shape": {"type": "sphere", "centre": [0, 0, 0], "radius": 2}, "lok": {}},
    "camera": {"eye": [0, -9, 3], "target": [0, 5, 1]}, "original": {"shape": {"type": "box"}}, "author": "me"})",
                                        "l.json");
  EXPECT_EQ(
      loaded.warnings,
      (std::vector<std::string>{
          "l.json: line 2, column 94: /optic/lok: unknown key, kept but not used; did you mean \"look\"?",
          "l.json: line 3, column 97: /author: unknown key, kept but not used"}));
  EXPECT_EQ(loaded.level.text->schema, "s.json");
}

TEST(FileFaults, AHeapOfThemIsCut) {
  std::string keys;
  for (int i = 0; i < 5000; ++i) keys += ", \"key" + std::to_string(i) + "\": 1";
  const std::vector<std::string> faults = faultsOf(R"({"format": "anamorph-level", "version": 1,
    "optic": {"kind": "none", "shape": {"type": "sphere", "centre": [0, 0, 0], "radius": 2}},
    "camera": {"eye": [0, -9, 3], "target": [0, 5, 1]}, "original": {"shape": {"type": "box"}},
    "lesson": {"id": "l", "steps": [])" + keys + "}}");
  ASSERT_EQ(faults.size(), 101u);
  EXPECT_EQ(faults.back(), "l.json: 4900 more faults");
}

}  // namespace
}  // namespace anamorph
