// Random points, directions and triangles for property tests. Print the seed.
#pragma once

#include <cstdint>
#include <random>

#include "geometry/mesh.h"

namespace anamorph {

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Point inCube(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
  Direction direction() {
    for (;;) {
      const Point p = inCube(1);
      if (lengthSquared(p) < 1 && lengthSquared(p) > 1e-4) return glm::normalize(p);
    }
  }

 private:
  std::mt19937 engine_;
};

/// Triangles whose corners lie within `size` of a point within `half` of the origin, along each axis.
inline Mesh makeSoup(Random& random, int triangles, double half, double size) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(triangles); ++i) {
    const Point p = random.inCube(half);
    for (int corner = 0; corner < 3; ++corner) mesh.positions.push_back(p + random.inCube(size));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

}  // namespace anamorph
