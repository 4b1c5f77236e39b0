#include "level/freeze.h"

#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "level/level_json.h"
#include "level/random_level.h"

namespace anamorph {
namespace {

TEST(Freeze, KeepsWhatTheSculptureIsMadeFromUntilItFollowsAgain) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Level level = following(RandomLevel(seed).make());
    Level kept = frozen(level);
    EXPECT_EQ(sculptureInputs(kept), sculptureInputs(level));
    EXPECT_FALSE(hasOriginalMoved(kept));
    EXPECT_EQ(following(kept), level);
    EXPECT_EQ(asMade(level), level);
    kept.camera.eye.x += 1;
    kept.optic.shape() = RandomLevel(seed + 1).make().optic.shape();
    kept.sculpture.depthScale *= 0.5;
    EXPECT_EQ(sculptureInputs(kept), sculptureInputs(level));
    EXPECT_EQ(frozen(kept), kept) << "it is frozen already";
    EXPECT_EQ(asMade(kept), level);
    EXPECT_FALSE(hasOriginalMoved(kept));
    kept.original.placement.position.y += 1;
    EXPECT_TRUE(hasOriginalMoved(kept));
    EXPECT_FALSE(hasOriginalMoved(following(kept)));
  }
}

std::string errorOf(const std::string& frozenJson) {
  std::string text = formatLevel(Level{});
  const std::string before = "\"sculpture\": {";
  text.insert(text.find(before) + before.size(), "\"frozen\": " + frozenJson + ", ");
  try {
    parseLevel(text, "f.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Freeze, AFileThatLeavesSomethingOutIsRefused) {
  EXPECT_EQ(errorOf("true"), "f.json: line 25, column 27: /sculpture/frozen: expected an object, got true");
  EXPECT_EQ(errorOf("{}"),
            "f.json: line 25, column 27: /sculpture/frozen: expected the key \"optic\", got an object "
            "without it (and 4 more)");
  EXPECT_NE(
      errorOf(R"({"optic": {"kind": "mirror", "shape": {"type": "sphere", "centre": [0, 0, 0], "radius": 0}},
                        "camera": {"eye": [0, 0, 0], "target": [0, 1, 0]}, "unitize": false, "placement": {},
                        "depthScale": 1})")
          .find("/sculpture/frozen/optic/shape/radius"),
      std::string::npos);
}

}  // namespace
}  // namespace anamorph
