#include "viewport/ray_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "anamorphosis/vertex_ray.h"
#include "geometry/shapes.h"
#include "pipeline/changing_levels.h"
#include "pipeline/stages.h"
#include "random_scene.h"
#include "raytrace/render.h"

namespace anamorph {
namespace {

using namespace testing;

constexpr RayKind allKinds[] = {RayKind::camera, RayKind::reflected, RayKind::light, RayKind::shadow,
                                RayKind::noHit};

/// A chain from the eye with rays to lights at its bends and perhaps one into the background at its end.
RayTree makeTree(Random& random) {
  RayTree tree;
  const auto color = [&] { return Color(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)); };
  tree.color = color() + Color(0.01);
  const auto add = [&](RayKind kind, int parent, const Point& from) {
    RaySegment segment;
    segment.kind = kind;
    segment.parent = parent;
    segment.from = from;
    segment.to = from + random.uniform(0.1, 5) * random.direction();
    segment.contribution = parent < 0 ? tree.color : tree.color * random.uniform(0, 1);
    tree.segments.push_back(segment);
  };
  Point at = random.point(5);
  int parent = -1;
  for (int bends = random.integer(1, 4); bends > 0; --bends) {
    add(parent < 0 ? RayKind::camera : RayKind::reflected, parent, at);
    parent = static_cast<int>(tree.segments.size()) - 1;
    at = tree.segments.back().to;
    for (int lights = random.integer(0, 2); lights > 0; --lights) {
      add(random.integer(0, 1) == 0 ? RayKind::light : RayKind::shadow, parent, at);
    }
  }
  if (random.integer(0, 1) == 0) add(RayKind::noHit, parent, at);
  return tree;
}

std::vector<RayTree> makeTrees(Random& random, int count) {
  std::vector<RayTree> trees;
  for (int i = 0; i < count; ++i) trees.push_back(makeTree(random));
  return trees;
}

RaySettings everything() {
  RaySettings settings;
  settings.lightRays = true;
  settings.hideNoHit = false;
  return settings;
}

double lengthOf(const Line& line) {
  return glm::length(line.to - line.from);
}

double totalLength(const std::vector<Line>& lines) {
  double length = 0;
  for (const Line& line : lines) length += lengthOf(line);
  return length;
}

/// Both ends, all else aside.
bool samePlace(const Line& line, const RaySegment& segment) {
  return line.from == segment.from && line.to == segment.to;
}

TEST(RayStyle, KindsDifferInColourAndAlsoWithoutColour) {
  std::set<std::string> looks, colors;
  for (const RayKind kind : allKinds) {
    const Line line = rayStyle(kind);
    EXPECT_EQ(line, makeLine(lookOf(kind).line)) << "as the legend says";
    EXPECT_EQ(line.color, inkOf(lookOf(kind).line.color));
    colors.insert(std::to_string(line.color.x) + "," + std::to_string(line.color.y) + "," +
                  std::to_string(line.color.z));
    looks.insert(std::to_string(int(line.style)) + std::to_string(line.arrow) + std::to_string(line.alpha));
  }
  EXPECT_EQ(colors.size(), 5u);
  EXPECT_EQ(looks.size(), 5u);
}

TEST(TreeLines, AreAllSegmentsInTheirKindsStyle) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto trees = makeTrees(random, random.integer(0, 6));
    RaySettings settings = everything();
    settings.thickness = random.uniform(0.5, 8);
    const auto lines = makeTreeLines(trees, settings, std::nullopt, 0);
    std::size_t next = 0;
    for (const RayTree& tree : trees) {
      for (const RaySegment& segment : tree.segments) {
        ASSERT_LT(next, lines.size());
        Line wanted = rayStyle(segment.kind);
        wanted.from = segment.from;
        wanted.to = segment.to;
        wanted.width = settings.thickness;
        EXPECT_EQ(lines[next++], wanted);
      }
    }
    EXPECT_EQ(next, lines.size());
    EXPECT_EQ(treeAnimationSeconds(trees, settings, std::nullopt), 0) << "nothing moves";
  }
}

TEST(TreeLines, OnlyOneTree) {
  Random random(1);
  const auto trees = makeTrees(random, 4);
  for (std::size_t only = 0; only < 4; ++only) {
    const auto lines = makeTreeLines(trees, everything(), only, 0);
    ASSERT_EQ(lines.size(), trees[only].segments.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      EXPECT_TRUE(samePlace(lines[i], trees[only].segments[i]));
    }
  }
  EXPECT_TRUE(makeTreeLines(trees, everything(), 4, 0).empty()) << "no such tree";
}

TEST(TreeLines, HideWhatTheSettingsHide) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto trees = makeTrees(random, 5);
    RaySettings settings;
    settings.lightRays = random.integer(0, 1) == 1;
    settings.hideNoHit = random.integer(0, 1) == 1;
    settings.hideNegligible = random.integer(0, 1) == 1;
    settings.negligible = random.uniform(0, 1);
    std::size_t wanted = 0;
    for (const RayTree& tree : trees) {
      const double whole = std::max({tree.color.x, tree.color.y, tree.color.z});
      for (const RaySegment& s : tree.segments) {
        const bool toLight = s.kind == RayKind::light || s.kind == RayKind::shadow;
        const double fraction = std::max({s.contribution.x, s.contribution.y, s.contribution.z}) / whole;
        wanted += (settings.lightRays || !toLight) && !(settings.hideNoHit && s.kind == RayKind::noHit) &&
                  !(settings.hideNegligible && fraction < settings.negligible);
      }
    }
    EXPECT_EQ(makeTreeLines(trees, settings, std::nullopt, 0).size(), wanted);
  }
}

TEST(TreeLines, ContributionDecidesWidthStrengthAndColour) {
  RayTree tree;
  tree.color = {0.5, 1, 0.25};
  for (const double fraction : {1.0, 0.5, 0.0}) {
    RaySegment segment;
    segment.kind = fraction == 1 ? RayKind::camera : RayKind::reflected;
    segment.parent = static_cast<int>(tree.segments.size()) - 1;
    segment.from = Point(fraction);
    segment.to = segment.from + Vector(1, 0, 0);
    segment.contribution = fraction * tree.color;
    tree.segments.push_back(segment);
  }
  RaySettings settings;
  settings.thicknessByContribution = settings.alphaByContribution = settings.colorByContribution = true;
  const auto lines = makeTreeLines({tree}, settings, std::nullopt, 0);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_GT(lines[0].width, settings.thickness);
  EXPECT_GT(lines[0].width, lines[1].width);
  EXPECT_GT(lines[1].width, lines[2].width);
  EXPECT_GT(lines[2].width, 0);
  EXPECT_NEAR(lines[0].alpha, 0.9, 1e-12);
  EXPECT_NEAR(lines[1].alpha, 0.65 * 0.5 + 0.25, 1e-12);
  EXPECT_NEAR(lines[2].alpha, 0.25, 1e-12);
  EXPECT_EQ(lines[0].color, glm::sqrt(tree.color));
  EXPECT_EQ(lines[2].color, Color(0));
  settings.alphaExponent = 0;
  EXPECT_EQ(makeTreeLines({tree}, settings, std::nullopt, 0)[2].alpha, 1);

  tree.color = Color(0);  // a black pixel: no ray gives it anything
  for (RaySegment& segment : tree.segments) segment.contribution = Color(0);
  for (const Line& line : makeTreeLines({tree}, settings, std::nullopt, 0)) {
    EXPECT_TRUE(std::isfinite(line.width) && std::isfinite(line.alpha) && isFinite(line.color));
  }
  tree.segments[0].contribution = Color(1e30);  // brighter than displays are
  const Color bright = makeTreeLines({tree}, settings, std::nullopt, 0)[0].color;
  EXPECT_EQ(bright, Color(1));
}

TEST(TreeLines, SegmentsWithoutLengthAreLeftOut) {
  RayTree tree;
  tree.color = Color(1);
  tree.segments.resize(2);
  tree.segments[1].parent = 0;
  tree.segments[1].to = {1, 0, 0};
  EXPECT_EQ(makeTreeLines({tree}, everything(), std::nullopt, 0).size(), 1u);
  RaySettings animated = everything();
  animated.animate = true;
  EXPECT_TRUE(makeTreeLines({tree}, animated, std::nullopt, 0).empty());
  EXPECT_EQ(makeTreeLines({tree}, animated, std::nullopt, 1).size(), 1u);
}

TEST(TreeAnimation, GrowsFromTheEyeChildrenAfterTheirParents) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto trees = makeTrees(random, random.integer(1, 6));
    RaySettings settings = everything();
    settings.animate = true;
    settings.sequential = random.integer(0, 1) == 1;
    settings.speed = random.uniform(0.5, 10);
    const double end = treeAnimationSeconds(trees, settings, std::nullopt);
    ASSERT_GT(end, 0);
    RaySettings still = settings;
    still.animate = false;
    const auto complete = makeTreeLines(trees, still, std::nullopt, 0);
    EXPECT_EQ(makeTreeLines(trees, settings, std::nullopt, end * (1 + 1e-12)), complete);
    EXPECT_EQ(makeTreeLines(trees, settings, std::nullopt, 1e6), complete);
    EXPECT_LT(totalLength(makeTreeLines(trees, settings, std::nullopt, 0.99 * end)), totalLength(complete));
    EXPECT_TRUE(makeTreeLines(trees, settings, std::nullopt, 0).empty());
    EXPECT_TRUE(makeTreeLines(trees, settings, std::nullopt, -1).empty());

    double before = 0;
    for (int step = 1; step <= 20; ++step) {
      const double seconds = end * step / 20;
      const auto lines = makeTreeLines(trees, settings, std::nullopt, seconds);
      EXPECT_GT(totalLength(lines), before) << "it never rests";
      before = totalLength(lines);
      // Each line is the beginning of the next segment in order that has begun, and where it ends is as far
      // from the eye as light has come.
      double way = settings.speed * seconds;
      std::size_t next = 0;
      for (const RayTree& tree : trees) {
        std::vector<double> ends;
        double longest = 0;
        for (const RaySegment& segment : tree.segments) {
          const double begin = segment.parent >= 0 ? ends[std::size_t(segment.parent)] : 0;
          const double length = glm::length(segment.to - segment.from);
          ends.push_back(begin + length);
          longest = std::max(longest, ends.back());
          if (way <= begin) continue;
          ASSERT_LT(next, lines.size());
          EXPECT_EQ(lines[next].from, segment.from);
          EXPECT_NEAR(lengthOf(lines[next]), std::min(length, way - begin), 1e-9);
          EXPECT_NEAR(glm::dot(glm::normalize(lines[next].to - segment.from),
                               glm::normalize(segment.to - segment.from)),
                      1, 1e-9);
          ++next;
        }
        if (settings.sequential) way -= longest;
      }
      EXPECT_EQ(next, lines.size());
    }
  }
}

TEST(TreeAnimation, HiddenRaysTakeNoTime) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    auto trees = makeTrees(random, 5);
    RayTree miss;  // a cell that sees the background only
    miss.segments.resize(1);
    miss.segments[0].kind = RayKind::noHit;
    miss.segments[0].to = {100, 0, 0};
    trees.insert(trees.begin() + 2, miss);
    RaySettings settings;  // as the program starts: no rays to lights, none into the background
    settings.animate = true;
    settings.sequential = seed % 2 == 0;
    const double end = treeAnimationSeconds(trees, settings, std::nullopt);
    double before = 0;
    for (int step = 1; step <= 50; ++step) {
      const double length = totalLength(makeTreeLines(trees, settings, std::nullopt, end * step / 50));
      EXPECT_GT(length, before) << "at step " << step;
      before = length;
    }
    EXPECT_EQ(treeAnimationSeconds({miss}, settings, std::nullopt), 0);
    RaySettings still = settings;
    still.animate = false;
    EXPECT_EQ(makeTreeLines(trees, settings, std::nullopt, end * (1 + 1e-12)),
              makeTreeLines(trees, still, std::nullopt, 0));
  }
}

TEST(TreeAnimation, SpeedZeroStandsStillAtTheBeginning) {
  Random random(2);
  const auto trees = makeTrees(random, 3);
  RaySettings settings = everything();
  settings.animate = true;
  settings.speed = 0;
  EXPECT_EQ(treeAnimationSeconds(trees, settings, std::nullopt), 0);
  for (const double seconds : {0.0, 1.0, 1e9}) {
    EXPECT_TRUE(makeTreeLines(trees, settings, std::nullopt, seconds).empty());
  }
  EXPECT_EQ(treeAnimationSeconds({}, settings, std::nullopt), 0);
}

TEST(TreeLines, OfAnInstalledLevelEndWhereItsThingsAre) {
  const Level level = quickLevels()[1];
  const PreparedMesh original = prepareMesh(placedOriginal(level));
  const RenderScene scene = buildScene(
      makeReflectionScene(level, prepareSculpture(makeSculpture(makeDeformInput(level, original.mesh)))));
  ImageRequest request;
  request.width = request.height = 8;
  std::vector<RayTree> trees;
  for (int i = 0; i < 64; ++i)
    trees.push_back(tracePath(scene, level.camera, request, {i % 8 + 0.5, i / 8 + 0.5}));
  int camera = 0, reflected = 0;
  for (const Line& line : makeTreeLines(trees, {}, std::nullopt, 0)) {
    EXPECT_TRUE(isFinite(line.from) && isFinite(line.to));
    camera += line.color == rayStyle(RayKind::camera).color;
    reflected += line.color == rayStyle(RayKind::reflected).color;
  }
  EXPECT_GT(camera, 30);
  EXPECT_GT(reflected, 5);
}

TEST(VertexRayLines, AreTheTwoLegsOfTheSampledVertices) {
  int unmapped = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Level level = changed(quickLevels()[seed % 3], random, 3);
    const auto original = placedOriginal(level);
    const int count = static_cast<int>(original->positions.size());
    RaySettings settings;
    settings.vertexCount = seed % 5 == 0 ? count + 7 : random.integer(1, 60);
    settings.hideNoHit = random.integer(0, 1) == 1;
    settings.thickness = 3;
    const auto lines = makeVertexRayLines(level, *original, settings, 0);
    std::size_t next = 0;
    std::set<int> seen;
    const int wanted = std::min(settings.vertexCount, count);
    for (int i = 0; i < wanted; ++i) {
      const int vertex = int((2LL * i + 1) * count / (2LL * wanted));
      seen.insert(vertex);
      const VertexRay ray = makeVertexRay(makeVertexMap(level), original->positions[vertex]);
      const bool mapped = ray.status == PathStatus::mapped;
      unmapped += !mapped;
      if (!mapped && settings.hideNoHit) continue;
      ASSERT_LT(next, lines.size());
      const Line& first = lines[next++];
      EXPECT_EQ(first.from, level.camera.eye);
      EXPECT_EQ(first.width, 3);
      EXPECT_EQ(first.color, rayStyle(mapped ? RayKind::camera : RayKind::noHit).color);
      if (!mapped) {
        EXPECT_GE(lengthOf(first) * (1 + 1e-12), glm::length(ray.original - ray.eye)) << "past P, or to it";
        continue;
      }
      EXPECT_EQ(first.to, ray.legs.back().start);
      ASSERT_LT(next, lines.size());
      const Line& second = lines[next++];
      EXPECT_EQ(second.from, ray.legs.back().start);
      EXPECT_EQ(second.to, ray.sculpture);
      EXPECT_EQ(second.color, rayStyle(RayKind::reflected).color);
    }
    EXPECT_EQ(next, lines.size());
    EXPECT_EQ(seen.size(), std::size_t(wanted)) << "no vertex twice";
  }
  EXPECT_GT(unmapped, 10);
}

TEST(VertexRayLines, NoneOfNothing) {
  const Level level;
  RaySettings settings;
  EXPECT_TRUE(makeVertexRayLines(level, {}, settings, 0).empty());
  EXPECT_EQ(vertexRayAnimationSeconds(level, {}, settings), 0);
  for (const int count : {0, -3}) {
    settings.vertexCount = count;
    EXPECT_TRUE(makeVertexRayLines(level, *placedOriginal(level), settings, 0).empty());
  }
}

TEST(VertexRayAnimation, GrowsFromTheEyeOverTheMirror) {
  for (unsigned seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Level level = changed(quickLevels()[seed % 3], random, 1);
    const auto original = placedOriginal(level);
    RaySettings settings;
    settings.vertexCount = random.integer(1, 12);
    settings.animate = true;
    settings.sequential = random.integer(0, 1) == 1;
    settings.speed = random.uniform(0.5, 10);
    settings.hideNoHit = random.integer(0, 1) == 1;
    RaySettings still = settings;
    still.animate = false;
    EXPECT_EQ(vertexRayAnimationSeconds(level, *original, still), 0);
    const auto complete = makeVertexRayLines(level, *original, still, 0);
    const double end = vertexRayAnimationSeconds(level, *original, settings);
    ASSERT_EQ(end > 0, !complete.empty());
    EXPECT_EQ(makeVertexRayLines(level, *original, settings, end * (1 + 1e-12)), complete);
    EXPECT_TRUE(makeVertexRayLines(level, *original, settings, 0).empty());
    if (complete.empty()) continue;
    if (settings.sequential) {
      EXPECT_NEAR(end, totalLength(complete) / settings.speed, 1e-9 * (1 + end));
    }
    double before = 0;
    for (int step = 1; step <= 20; ++step) {
      const auto lines = makeVertexRayLines(level, *original, settings, end * step / 20);
      EXPECT_GT(totalLength(lines), before);
      before = totalLength(lines);
      for (const Line& line : lines) {
        if (line.from == level.camera.eye) continue;
        bool reached = false;  // a second leg is there only when the first one has come to the mirror
        for (const Line& first : lines) reached |= first.from == level.camera.eye && first.to == line.from;
        EXPECT_TRUE(reached);
      }
      if (settings.sequential) {
        EXPECT_NEAR(totalLength(lines), end * step / 20 * settings.speed, 1e-9 * (1 + before));
      }
    }
    settings.speed = 0;
    EXPECT_EQ(vertexRayAnimationSeconds(level, *original, settings), 0);
    EXPECT_TRUE(makeVertexRayLines(level, *original, settings, 5).empty());
  }
}

}  // namespace
}  // namespace anamorph
