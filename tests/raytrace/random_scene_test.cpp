// Whatever the scene, a colour is a finite number: eyes on and in things, needles and points among the
// triangles, lights on surfaces, any size.
#include <gtest/gtest.h>

#include "raytrace/test_scenes.h"
#include "shapes.h"

namespace anamorph::test {
namespace {

class RandomScene {
 public:
  explicit RandomScene(unsigned seed) : random_(seed), scale_(std::pow(10, number(-3, 5))) {
    const int surfaces = index(3);
    for (int i = 0; i < surfaces; ++i)
      input.surfaces.push_back(makeSurface("mesh", makeMesh(), makeMaterial(), number(0, 180)));
    if (index(4) > 0)
      input.optic = OpticSurface{Optic{OpticKind::mirror, makeShape()}, color(), number(0, 1)};
    if (index(2) > 0) input.ground = Ground{scale_ * number(-1, 1), makeMaterial(), scale_ * number(0, 0.5)};
    const int lights = index(3);
    for (int i = 0; i < lights; ++i) input.lights.push_back({somewhere(), color(), number(0, 3)});
    input.background = {color(), color()};
  }

  // Often a place where something is.
  Point somewhere() {
    const int choice = index(4);
    if (choice == 0 && !input.surfaces.empty()) {
      const PointArray& points = input.surfaces[0].mesh->positions;
      return points[static_cast<std::size_t>(index(static_cast<int>(points.size())))];
    }
    if (choice == 1 && input.optic) {
      const PointArray points = tessellate(input.optic->optic.shape()).mesh.positions;
      return points[static_cast<std::size_t>(index(static_cast<int>(points.size())))];
    }
    if (choice == 2 && !input.lights.empty()) return input.lights[0].position;
    return point();
  }

  Direction direction() {
    const Vector v(number(-1, 1), number(-1, 1), number(-1, 1));
    return index(5) == 0 ? Direction(0, 0, -1) : glm::normalize(v + Vector(1e-9));
  }

  int index(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  SceneInput input;

 private:
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Point point() { return scale_ * Point(number(-1, 1), number(-1, 1), number(-1, 1)); }
  Color color() { return {number(0, 1), number(0, 1), number(0, 1)}; }
  Material makeMaterial() { return {color(), number(0, 1), number(0, 1), number(0, 1), number(1, 128)}; }

  Mesh makeMesh() {
    Mesh mesh;
    for (int i = 0; i < 12; ++i) mesh.positions.push_back(point());
    mesh.positions.push_back(mesh.positions[0]);
    for (int i = 0; i < 20; ++i) {
      const auto corner = [&] { return static_cast<std::uint32_t>(index(13)); };
      mesh.triangles.push_back({corner(), corner(), corner()});  // some have equal corners
    }
    return mesh;
  }

  Shape makeShape() {
    switch (index(4)) {
      case 0: {
        const Point corner = point();
        const Vector a = point(), b = 0.5 * point();
        return PlaneMirror{{corner, corner + a, corner + a + b, corner + b}};
      }
      case 1:
        return CylinderMirror{point(), point(), scale_ * number(0.05, 1)};
      case 2:
        return ConeMirror{point(), point(), scale_ * number(0, 1), scale_ * number(0.05, 1)};
      default:
        return SphereMirror{point(), scale_ * number(0.05, 1)};
    }
  }

  std::mt19937 random_;
  double scale_;
};

TEST(RandomScenes, GiveFiniteColoursAndTheSamePathsAsPictures) {
  for (unsigned seed = 0; seed < 1500; ++seed) {
    RandomScene random(seed);
    const RenderScene scene = buildScene(random.input);
    for (int i = 0; i < 20; ++i) {
      const Ray ray{random.somewhere(), random.direction()};
      TraceOptions options;
      options.maxDepth = random.index(maxTraceDepth + 1);
      options.shadows = random.index(3) > 0;
      const Color color = traceColor(scene, ray, options);
      const RayTree tree = tracePath(scene, ray, options);
      ASSERT_TRUE(isFinite(color)) << "seed " << seed << ", ray " << i;
      ASSERT_TRUE(color.x >= 0 && color.y >= 0 && color.z >= 0) << "seed " << seed << ", ray " << i;
      ASSERT_EQ(color, tree.color) << "seed " << seed << ", ray " << i;
      for (const RaySegment& segment : tree.segments) {
        ASSERT_TRUE(isFinite(segment.from) && isFinite(segment.to)) << "seed " << seed << ", ray " << i;
        ASSERT_TRUE(isFinite(segment.weight) && isFinite(segment.contribution))
            << "seed " << seed << ", ray " << i;
      }
    }
  }
}

}  // namespace
}  // namespace anamorph::test
