// Random mirrors, eyes and originals for property tests. The seed of every case is in the failure message.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "math/frame.h"
#include "math/placement.h"
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

enum class ShapeKind { plane, cylinder, sphere, cone, ellipsoid, paraboloid };
constexpr ShapeKind curvedShapeKinds[] = {ShapeKind::cylinder, ShapeKind::sphere, ShapeKind::cone,
                                          ShapeKind::ellipsoid, ShapeKind::paraboloid};
constexpr ShapeKind allShapeKinds[] = {ShapeKind::plane, ShapeKind::cylinder,  ShapeKind::sphere,
                                       ShapeKind::cone,  ShapeKind::ellipsoid, ShapeKind::paraboloid};

struct RandomScene {
  Optic optic;
  Point eye;
  Point onMirror;    ///< a point of the mirror that the eye sees, at more than a few degrees
  Direction normal;  ///< there, towards the eye
};

// A rotated quad, a tilted cylinder, cone or bowl, a sphere or an ellipsoid, and an eye that sees the returned point of it from outside.
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
  } else if (kind == ShapeKind::ellipsoid) {
    const Vector radii(random.uniform(1, 4), random.uniform(1, 4), random.uniform(1, 4));
    const Vector angles = random.point(180);
    scene.optic.shape() = EllipsoidMirror{centre, radii, angles};
    const glm::dmat3 own = rotationMatrix(angles);
    scene.onMirror = centre + own * (radii * n);
    scene.normal = glm::normalize(own * (n / radii));
  } else if (kind == ShapeKind::paraboloid) {
    const double radius = random.uniform(1, 4), focal = random.uniform(0.2, 1) * radius;
    const double hole = random.integer(0, 1) == 0 ? 0 : random.uniform(0.1, 0.5) * radius;
    scene.optic.shape() = ParaboloidMirror{centre, random.uniform(0.1, 9) * frame.up, focal, radius, hole};
    const double rho = hole + random.uniform(0.1, 0.9) * (radius - hole);
    scene.onMirror = centre + rho * n + rho * rho / (4 * focal) * frame.up;
    scene.normal = glm::normalize(rho * n - 2 * focal * frame.up);
  } else {
    const double radius = random.uniform(0.5, 4);
    scene.optic.shape() = SphereMirror{centre, radius};
    scene.onMirror = centre + radius * n;
    scene.normal = n;
  }
  // Up to 70 degrees from the normal, not along it exactly.
  const double tilt = radians(random.uniform(1, 70)), turn = random.uniform(0, 2 * pi);
  const Frame around = scene.normal == n ? frame : makeFrame(scene.normal, frame.up);
  const Direction side = std::cos(turn) * around.right + std::sin(turn) * around.up;
  scene.eye =
      scene.onMirror + random.uniform(2, 20) * (std::cos(tilt) * scene.normal + std::sin(tilt) * side);
  return scene;
}

// The same mirrors, curved ones only, and an eye within, on the way from another point of the surface to the returned one.
inline RandomScene makeHollowScene(ShapeKind kind, Random& random) {
  RandomScene scene = makeRandomScene(kind, random);
  scene.normal = -scene.normal;
  do {
    const Point opposite = pointAt(scene.optic.shape(), random.uniform(0, 1), random.uniform(0, 1));
    scene.eye = glm::mix(opposite, scene.onMirror, random.uniform(0.1, 0.9));
  } while (!(glm::dot(glm::normalize(scene.eye - scene.onMirror), scene.normal) > 0.1));
  return scene;
}

// A point that the eye would see behind onMirror, 0.2 to 6 beyond it, aimed up to `spread` beside it.
inline Point makeRandomOriginal(const RandomScene& scene, Random& random, double spread = 0) {
  const Point aim = scene.onMirror + random.point(1) * spread;
  return aim + random.uniform(0.2, 6) * glm::normalize(aim - scene.eye);
}

}  // namespace anamorph::testing
