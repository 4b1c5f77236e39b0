#include "viewport/bands.h"

#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace anamorph {
namespace {

constexpr PixelRect areas[] = {{0, 0, 1, 1},   {0, 0, 7, 300},      {0, 0, 256, 8}, {0, 0, 257, 9},
                               {3, 5, 700, 3}, {250, 7, 1021, 603}, {0, 0, 0, 50},  {10, 10, 50, 0}};

TEST(Bands, CoverEveryPixelOnce) {
  for (const PixelRect& area : areas) {
    SCOPED_TRACE(::testing::Message() << area.x << " " << area.y << " " << area.width << " " << area.height);
    std::vector<int> times(static_cast<std::size_t>(area.width) * area.height);
    const Bands bands(area);
    for (int i = 0; i < bands.count(); ++i) {
      const PixelRect piece = bands.at(i);
      ASSERT_GE(piece.x, area.x);
      ASSERT_GE(piece.y, area.y);
      ASSERT_LE(piece.x + piece.width, area.x + area.width);
      ASSERT_LE(piece.y + piece.height, area.y + area.height);
      EXPECT_LE(piece.width * piece.height, 4096) << "a piece is small";
      for (int y = 0; y < piece.height; ++y) {
        for (int x = 0; x < piece.width; ++x)
          ++times[static_cast<std::size_t>(piece.y - area.y + y) * area.width + piece.x - area.x + x];
      }
    }
    EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
  }
}

// So a few of them take about as long as any other few, wherever the picture is slow to draw.
TEST(Bands, FollowEachOtherFarApart) {
  const Bands bands({0, 0, 1280, 800});
  constexpr int few = 20;
  for (int from = 0; from + few <= bands.count(); from += few) {
    std::set<int> quarters;
    for (int i = from; i < from + few; ++i) quarters.insert(bands.at(i).y / 200);
    EXPECT_EQ(quarters.size(), 4u) << from;
  }
}

TEST(ListPieces, CoverTheListOnce) {
  for (const ListPieces& list : {ListPieces{0, 5}, {1, 5}, {5, 5}, {6, 5}, {100, 7}}) {
    EXPECT_EQ(list.begin(0), 0);
    EXPECT_EQ(list.begin(list.count()), list.length);
    for (int i = 0; i < list.count(); ++i) {
      EXPECT_GT(list.begin(i + 1), list.begin(i));
      EXPECT_LE(list.begin(i + 1) - list.begin(i), list.each);
    }
  }
}

}  // namespace
}  // namespace anamorph
