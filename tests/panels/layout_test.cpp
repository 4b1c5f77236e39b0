#include "panels/layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "random_scene.h"

namespace anamorph {
namespace {

using testing::Random;

struct Named {
  const char* name;
  Rect rect;
};

std::vector<Named> partsOf(const Layout& layout) {
  return {{"menu", layout.menu},
          {"left", layout.left},
          {"lesson", layout.lesson},
          {"view", layout.view},
          {"properties", layout.properties},
          {"preview", layout.preview},
          {"status", layout.status},
          {"words", layout.words}};
}

float overlap(float a, float aSize, float b, float bSize) {
  return std::min(a + aSize, b + bSize) - std::max(a, b);
}

/// Inside the window, side by side, and together all of it.
void expectTiles(const LayoutInput& in) {
  SCOPED_TRACE(std::to_string(in.width) + " x " + std::to_string(in.height) + " at scale " +
               std::to_string(in.scale) + ", sides " + std::to_string(in.leftWidth) + ", " +
               std::to_string(in.rightWidth) + ", " + std::to_string(in.previewHeight) +
               (in.previewExpanded ? ", expanded" : "") + (in.panelsHidden ? ", hidden" : ""));
  const float rounding = 1e-3f * std::max(1.0f, std::max(in.width, in.height) / 1000);
  const std::vector<Named> parts = partsOf(makeLayout(in));
  float area = 0;
  for (const Named& part : parts) {
    const Rect& r = part.rect;
    EXPECT_GE(r.width, 0) << part.name;
    EXPECT_GE(r.height, 0) << part.name;
    if (r.empty()) continue;
    area += r.width * r.height;
    EXPECT_GE(r.x, -rounding) << part.name;
    EXPECT_GE(r.y, -rounding) << part.name;
    EXPECT_LE(r.x + r.width, in.width + rounding) << part.name;
    EXPECT_LE(r.y + r.height, in.height + rounding) << part.name;
    for (const Named& other : parts) {
      if (other.name == part.name || other.rect.empty()) continue;
      EXPECT_FALSE(overlap(r.x, r.width, other.rect.x, other.rect.width) > rounding &&
                   overlap(r.y, r.height, other.rect.y, other.rect.height) > rounding)
          << part.name << " and " << other.name;
    }
  }
  EXPECT_NEAR(area, in.width * in.height, 1e-4f * in.width * in.height + 1);
}

TEST(Layout, FillsEveryWindowWithoutOverlap) {
  for (const float width : {1, 17, 100, 320, 640, 800, 1024, 1280, 1920, 2560, 3840}) {
    for (const float height : {1, 20, 56, 100, 301, 480, 600, 800, 1080, 2160}) {
      for (const float scale : {0.75f, 1.0f, 1.25f, 1.5f, 2.0f, 3.0f}) {
        for (const bool expanded : {false, true}) {
          expectTiles({width, height, scale, 264, 336, 440, false, false, expanded});
          expectTiles({width, height, scale, 264, 336, 440, true, false, expanded});
        }
      }
    }
  }
}

TEST(Layout, AlsoWithSplittersAnywhere) {
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    LayoutInput in;
    in.width = static_cast<float>(random.integer(1, 3840));
    in.height = static_cast<float>(random.integer(1, 2160));
    in.scale = static_cast<float>(random.uniform(0.75, 3));
    in.leftWidth = static_cast<float>(random.uniform(0, 2000));
    in.rightWidth = static_cast<float>(random.uniform(0, 2000));
    in.previewHeight = static_cast<float>(random.uniform(0, 2000));
    in.previewExpanded = random.integer(0, 1) == 1;
    expectTiles(in);
  }
}

TEST(Layout, ShowsEverythingInAnOrdinaryWindowAndTheViewAlwaysHasRoom) {
  for (const float scale : {0.75f, 1.0f, 1.5f, 2.0f}) {
    const Layout layout = makeLayout({1280 * scale, 800 * scale, scale, 264, 336, 440});
    for (const Named& part : partsOf(layout)) {
      const bool isForAnAudience = std::string(part.name) == "words";
      EXPECT_EQ(part.rect.empty(), isForAnAudience) << part.name;
    }
    EXPECT_GT(layout.view.width, layout.left.width + 200 * scale);
  }
  for (const float width : {1.0f, 300.0f, 500.0f, 700.0f, 900.0f, 1280.0f, 3840.0f}) {
    for (const float scale : {0.75f, 1.0f, 2.0f, 3.0f}) {
      const Rect view = makeLayout({width, 800, scale, 264, 336, 440}).view;
      EXPECT_GE(view.width, std::min(width, 240 * scale) - 1e-3f) << width << " at " << scale;
    }
  }
}

TEST(Layout, SidesGiveWayBeforeTheyGo) {
  const auto at = [](float width) { return makeLayout({width, 800, 1, 264, 336, 440}); };
  EXPECT_FLOAT_EQ(at(840).left.width, 264);
  EXPECT_FLOAT_EQ(at(840).properties.width, 336);
  EXPECT_GE(at(700).left.width, smallestLeft);
  EXPECT_LT(at(700).left.width, 264);
  EXPECT_GE(at(700).properties.width, smallestRight);
  EXPECT_LT(at(700).properties.width, 336);
  EXPECT_NEAR(at(700).view.width, 240, 2);
  EXPECT_TRUE(at(640).left.empty());
  EXPECT_FALSE(at(640).properties.empty());
}

TEST(Layout, AProjectorAtTwiceTheSizeHasItsLesson) {
  // 200 %, and the projector theme's quarter more.
  const Layout layout = makeLayout({1920, 1080, 2.5f, 264, 336, 416, false, false, false, 6});
  EXPECT_TRUE(layout.left.empty()) << "the list leaves its room to the lesson";
  EXPECT_GE(layout.lesson.height, 250 * 2.5f);
  EXPECT_GE(layout.lesson.width, smallestLeft * 2.5f);
  EXPECT_FALSE(layout.preview.empty());
}

TEST(Layout, SmallWindowsLoseTheSidesFirst) {
  const auto at = [](float width) { return makeLayout({width, 800, 1, 264, 336, 440}); };
  EXPECT_TRUE(at(400).properties.empty());
  EXPECT_TRUE(at(400).preview.empty());
  EXPECT_EQ(at(400).view.width, 400);
}

TEST(Layout, HiddenPanelsLeaveTheViewAlone) {
  const Layout layout = makeLayout({1280, 800, 1, 264, 336, 440, true});
  EXPECT_EQ(layout.view, (Rect{0, 0, 1280, 800}));
  for (const Named& part : partsOf(layout)) {
    EXPECT_TRUE(part.rect.empty() || part.rect == layout.view) << part.name;
  }
}

TEST(Layout, AnAudienceSeesThePreviewAndTheWordsBesideTheView) {
  for (const auto& [width, height] : {std::pair{1280.0f, 800.0f}, {1920.0f, 1080.0f}}) {
    for (const float scale : {1.0f, 1.25f, 1.875f}) {
      LayoutInput in{width, height, scale, 264, 336, 440, true, true};
      in.wordsHeight = 150.4f;
      expectTiles(in);
      const Layout layout = makeLayout(in);
      EXPECT_GT(layout.view.width, layout.preview.width) << scale;
      EXPECT_GE(layout.preview.width, smallestRight * scale - 1);
      EXPECT_EQ(layout.words, (Rect{0, height - 151, width, 151}));
      EXPECT_TRUE(layout.properties.empty() && layout.lesson.empty());
      in.wordsHeight = 1e4f;
      EXPECT_LE(makeLayout(in).words.height, 0.4f * height) << "the view is worth more than any text";
    }
  }
}

TEST(Layout, BordersAreAtWholePixels) {
  for (const float scale : {1.0f, 1.25f, 1.875f}) {
    for (const Named& part : partsOf(makeLayout({1281, 803, scale, 264.3f, 336.7f, 440.1f}))) {
      for (const float place : {part.rect.x, part.rect.y, part.rect.width, part.rect.height})
        EXPECT_EQ(place, std::round(place)) << part.name << " at " << scale;
    }
  }
}

TEST(Layout, ExpandedPreviewIsLarge) {
  const Layout small = makeLayout({1280, 800, 1, 264, 336, 440});
  const Layout large = makeLayout({1280, 800, 1, 264, 336, 440, false, false, true});
  EXPECT_FLOAT_EQ(large.preview.width, 640);
  EXPECT_GE(large.preview.height, small.preview.height);
  EXPECT_FALSE(large.properties.empty());
}

TEST(Rect, ContainsItsLowerEdgesOnly) {
  const Rect rect{10, 20, 5, 6};
  EXPECT_TRUE(rect.contains(10, 20));
  EXPECT_TRUE(rect.contains(14.9f, 25.9f));
  EXPECT_FALSE(rect.contains(15, 22));
  EXPECT_FALSE(rect.contains(12, 26));
  EXPECT_TRUE(Rect().empty());
  EXPECT_FALSE(Rect().contains(0, 0));
}

TEST(FittingScale, LeavesRoomForAllPanels) {
  for (const auto& [width, height] :
       {std::pair{1280.0, 800.0}, {1920.0, 1080.0}, {1024.0, 768.0}, {800.0, 600.0}}) {
    for (const double wanted : {0.75, 1.0, 1.25, 2.0, 2.5, 3.75}) {
      SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height) + ", " + std::to_string(wanted));
      const double scale = fittingScale(wanted, width, height);
      EXPECT_LE(scale, wanted);
      EXPECT_GE(scale, std::min(wanted, 1.0));
      LayoutInput in;
      in.width = static_cast<float>(width);
      in.height = static_cast<float>(height);
      in.scale = static_cast<float>(scale);
      in.leftWidth = 264;
      in.rightWidth = 336;
      in.previewHeight = 416;
      in.levels = 6;
      const Layout layout = makeLayout(in);
      for (const Rect& rect :
           {layout.menu, layout.lesson, layout.view, layout.properties, layout.preview, layout.status})
        EXPECT_FALSE(rect.empty());
    }
  }
  EXPECT_EQ(fittingScale(2.5, 320, 200), 1) << "there the panels give way";
  EXPECT_EQ(fittingScale(2, 1920, 1080), 2);
}

}  // namespace
}  // namespace anamorph
