#include <gtest/gtest.h>

#include "optics/reflect.h"
#include "raytrace/scene_hit.h"
#include "raytrace/test_scenes.h"

namespace anamorph::test {
namespace {

std::vector<RayTree> treesOf(const RenderScene& scene, const Camera& camera, const ImageRequest& request) {
  std::vector<RayTree> trees;
  for (int y = 0; y < request.height; ++y) {
    for (int x = 0; x < request.width; ++x)
      trees.push_back(tracePath(scene, camera, request, Pixel(x + 0.5, y + 0.5)));
  }
  return trees;
}

class TracedPaths : public testing::Test {
 protected:
  const RenderScene scene = buildScene(makeStudio());
  const ImageRequest request = smallImage(48, 40);
  const std::vector<RayTree> trees = treesOf(scene, studioCamera(), request);
};

TEST_F(TracedPaths, AreThoseOfTheImage) {
  const auto image = render(scene, studioCamera(), request);
  ASSERT_TRUE(image);
  for (std::size_t i = 0; i < trees.size(); ++i) {
    ASSERT_EQ(glm::vec3(trees[i].color), image->pixels[i]) << "pixel " << i;
    ASSERT_EQ(trees[i].segments[0].contribution, trees[i].color) << "pixel " << i;
  }
}

TEST_F(TracedPaths, BranchAtSurfaces) {
  const Point eye = studioCamera().eye;
  int seen[5] = {};
  for (const RayTree& tree : trees) {
    for (std::size_t i = 0; i < tree.segments.size(); ++i) {
      const RaySegment& segment = tree.segments[i];
      ++seen[static_cast<int>(segment.kind)];
      if (i == 0) {
        EXPECT_EQ(segment.parent, -1);
        EXPECT_EQ(segment.from, eye);
        EXPECT_EQ(segment.depth, 0);
        continue;
      }
      ASSERT_GE(segment.parent, 0);
      ASSERT_LT(segment.parent, static_cast<int>(i));
      const RaySegment& parent = tree.segments[segment.parent];
      EXPECT_LE(glm::length(segment.from - parent.to), 2 * scene.epsilon);
    }
  }
  for (const int count : seen) EXPECT_GT(count, 20) << "every kind is there";
}

TEST_F(TracedPaths, ReflectedRaysObeyTheLawOfReflection) {
  for (const RayTree& tree : trees) {
    for (const RaySegment& segment : tree.segments) {
      if (segment.kind != RayKind::reflected) continue;
      const RaySegment& parent = tree.segments[segment.parent];
      ASSERT_EQ(parent.object.kind, ObjectKind::optic);
      EXPECT_EQ(segment.depth, parent.depth + 1);
      const Direction in = glm::normalize(parent.to - parent.from),
                      out = glm::normalize(segment.to - segment.from);
      const Direction normal = glm::normalize(Vector(parent.to.x, parent.to.y, 0));
      EXPECT_LT(glm::length(out - reflect(in, normal)), 1e-5);
    }
  }
}

TEST_F(TracedPaths, LightRaysEndAtLightsAndShadowRaysAtBlockers) {
  for (const RayTree& tree : trees) {
    for (const RaySegment& segment : tree.segments) {
      const Point start = segment.from;
      if (segment.kind == RayKind::light) {
        ASSERT_EQ(segment.object.kind, ObjectKind::light);
        const PointLight& light = scene.input.lights[segment.object.index];
        EXPECT_EQ(segment.to, light.position);
        EXPECT_LT(glm::length(segment.contribution - segment.weight * light.intensity * light.color), 1e-15);
      }
      if (segment.kind == RayKind::shadow) {
        EXPECT_NE(segment.object.kind, ObjectKind::light);
        EXPECT_NE(segment.object.kind, ObjectKind::none);
        EXPECT_EQ(segment.contribution, Color(0));
        const auto hit = findHit(scene, {start, glm::normalize(segment.to - start)});
        EXPECT_GT(glm::length(segment.to - start), 10 * scene.epsilon);
        ASSERT_TRUE(hit) << "something is there";
      }
      if (segment.kind == RayKind::noHit) {
        EXPECT_EQ(segment.object, ObjectId{});
        EXPECT_FALSE(findHit(scene, {start, glm::normalize(segment.to - start)}));
      }
    }
  }
}

TEST_F(TracedPaths, ContributionsOfChildrenAddUp) {
  for (const RayTree& tree : trees) {
    std::vector<Color> fromChildren(tree.segments.size(), Color(0));
    for (const RaySegment& segment : tree.segments) {
      if (segment.parent >= 0) fromChildren[segment.parent] += segment.contribution;
    }
    for (std::size_t i = 0; i < tree.segments.size(); ++i) {
      const RaySegment& segment = tree.segments[i];
      const Color own = segment.contribution - fromChildren[i];
      for (int c = 0; c < 3; ++c) EXPECT_GE(own[c], -1e-14);
      if (segment.object.kind == ObjectKind::mesh && segment.kind != RayKind::shadow) {
        const Material& material = scene.input.surfaces[0].material;
        EXPECT_LT(glm::length(own - segment.weight * material.ambient * material.color), 1e-14);
      }
    }
  }
}

TEST(TracePath, WithoutShadowsEveryLightInFrontReachesTheSurface) {
  const RenderScene scene = buildScene(makeStudio());
  ImageRequest request = smallImage(24, 24);
  request.shadows = false;
  for (const RayTree& tree : treesOf(scene, studioCamera(), request)) {
    for (const RaySegment& segment : tree.segments) EXPECT_NE(segment.kind, RayKind::shadow);
  }
}

}  // namespace
}  // namespace anamorph::test
