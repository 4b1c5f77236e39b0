// Random mirrors, eyes and originals for property tests. The seed of every case is in the failure message.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "math/frame.h"
#include "optics/optic.h"
#include "shapes.h"

namespace anamorph::testing {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  Direction direction() {
    const double z = uniform(-1, 1), angle = uniform(0, 2 * pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  Point point(double extent) {
    return {uniform(-extent, extent), uniform(-extent, extent), uniform(-extent, extent)};
  }

 private:
  std::mt19937_64 engine_;
};

enum class ShapeKind { plane, cylinder, sphere, cone };
constexpr ShapeKind allShapeKinds[] = {ShapeKind::plane, ShapeKind::cylinder, ShapeKind::sphere,
                                       ShapeKind::cone};

struct RandomScene {
  Optic optic;
  Point eye;
  Point onMirror;    ///< a point of the mirror that the eye sees, at more than a few degrees
  Direction normal;  ///< there, towards the eye
};

// A rotated quad, a tilted cylinder or cone, or a sphere, and an eye that sees the returned point of it from outside.
inline RandomScene makeRandomScene(ShapeKind kind, Random& random) {
  RandomScene scene;
  const Point centre = random.point(5);
  const Direction n = random.direction();
  const Frame frame = makeFrame(n, random.direction());
  if (kind == ShapeKind::plane) {
    const double w = random.uniform(3, 8), h = random.uniform(3, 8);
    const Vector x = w * frame.right, y = h * frame.up;
    scene.optic.shape() = PlaneMirror{{centre - x - y, centre + x - y, centre + x + y, centre - x + y}};
    scene.onMirror = centre + random.uniform(-0.9, 0.9) * x + random.uniform(-0.9, 0.9) * y;
    scene.normal = n;
  } else if (kind == ShapeKind::cylinder) {
    const double radius = random.uniform(0.5, 4), height = random.uniform(4, 12);
    scene.optic.shape() = CylinderMirror{centre, centre + height * frame.up, radius};
    scene.onMirror = centre + random.uniform(0.1, 0.9) * height * frame.up + radius * n;
    scene.normal = n;
  } else if (kind == ShapeKind::cone) {
    const double height = random.uniform(4, 12), wide = random.uniform(2, 4);
    const double narrow = random.integer(0, 3) == 0 ? 0 : random.uniform(0.5, 2);  // one end may be a point
    const bool upright = random.integer(0, 1) == 0;
    const ConeMirror cone{centre, centre + height * frame.up, upright ? wide : narrow,
                          upright ? narrow : wide};
    scene.optic.shape() = cone;
    const double away = random.uniform(0.1, 0.7), v = upright ? away : 1 - away;  // not at the point
    const double radius = (1 - v) * cone.bottomRadius + v * cone.topRadius;
    scene.onMirror = centre + v * height * frame.up + radius * n;
    scene.normal = glm::normalize(n - (cone.topRadius - cone.bottomRadius) / height * frame.up);
  } else {
    const double radius = random.uniform(0.5, 4);
    scene.optic.shape() = SphereMirror{centre, radius};
    scene.onMirror = centre + radius * n;
    scene.normal = n;
  }
  // Up to 70 degrees from the normal, not along it exactly.
  const double tilt = radians(random.uniform(1, 70)), turn = random.uniform(0, 2 * pi);
  const Frame around = kind == ShapeKind::cone ? makeFrame(scene.normal, frame.up) : frame;
  const Direction side = std::cos(turn) * around.right + std::sin(turn) * around.up;
  scene.eye =
      scene.onMirror + random.uniform(2, 20) * (std::cos(tilt) * scene.normal + std::sin(tilt) * side);
  return scene;
}

// A point that the eye would see behind onMirror, 0.2 to 6 beyond it, aimed up to `spread` beside it.
inline Point makeRandomOriginal(const RandomScene& scene, Random& random, double spread = 0) {
  const Point aim = scene.onMirror + random.point(1) * spread;
  return aim + random.uniform(0.2, 6) * glm::normalize(aim - scene.eye);
}

}  // namespace anamorph::testing
