#include "viewport/construction_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "edit/edit_levels.h"
#include "pipeline/stages.h"
#include "viewport/ray_lines.h"

namespace anamorph {
namespace {

using namespace testing;
using Kind = ConstructionSegment::Kind;

TEST(ConstructionLines, AreItsSegmentsThenItsArcs) {
  for (const ShapeKind shape : allShapeKinds) {
    for (unsigned seed = 0; seed < 50; ++seed) {
      SCOPED_TRACE("mirror " + std::to_string(int(shape)) + ", seed " + std::to_string(seed));
      Random random(seed);
      const Level level = makeRandomLevel(shape, random);
      const Construction made =
          makeConstruction(makeVertexMap(level), level.original.placement.position + random.point(seed % 5));
      const auto lines = makeConstructionLines(made);
      std::size_t next = 0;
      for (const ConstructionSegment& segment : made.segments) {
        ASSERT_LT(next, lines.size());
        EXPECT_EQ(lines[next].from, segment.from);
        EXPECT_EQ(lines[next++].to, segment.to);
      }
      for (const ConstructionArc& arc : made.arcs) {
        for (std::size_t i = 1; i < arc.points.size(); ++i) {
          ASSERT_LT(next, lines.size());
          EXPECT_EQ(lines[next].from, arc.points[i - 1]);
          EXPECT_EQ(lines[next++].to, arc.points[i]);
        }
      }
      EXPECT_EQ(next, lines.size());
      for (const Line& line : lines) EXPECT_TRUE(line.inFront && isFinite(line.from) && isFinite(line.to));
    }
  }
}

TEST(ConstructionLines, KindsCanBeToldApartAndRaysLookLikeRays) {
  Construction made;
  for (const Kind kind : {Kind::incident, Kind::virtualRay, Kind::reflected, Kind::normal}) {
    made.segments.push_back({Point(0), Point(1), kind});
  }
  const auto lines = makeConstructionLines(made);
  ASSERT_EQ(lines.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(lines[i].color, lines[j].color);
  }
  EXPECT_EQ(lines[0].color, rayStyle(RayKind::camera).color);
  EXPECT_EQ(lines[0].style, rayStyle(RayKind::camera).style);
  EXPECT_EQ(lines[2].color, rayStyle(RayKind::reflected).color);
  EXPECT_EQ(lines[2].style, rayStyle(RayKind::reflected).style);
  EXPECT_NE(lines[1].style, LineStyle::solid) << "no light goes there";
}

TEST(ConstructionLines, NothingOfNothing) {
  EXPECT_TRUE(makeConstructionLines({}).empty());
}

}  // namespace
}  // namespace anamorph
