// Meshes to write and read in tests.
#pragma once

#include <cmath>
#include <iterator>
#include <random>

#include "geometry/mesh.h"

namespace anamorph::testing {

/// Coordinates of all magnitudes that a file may hold, awkward ones among them, and arbitrary valid
/// triangles that use every vertex.
inline Mesh makeRandomMesh(std::mt19937_64& random) {
  std::uniform_int_distribution<std::uint32_t> size(3, 40);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-330, 8), kind(0, 9);
  const auto coordinate = [&]() -> double {
    const double awkward[] = {0.0, -0.0, 5e-324, 1e9, -1e9, 0.1, 1.0 / 3};
    if (kind(random) == 0) return awkward[random() % std::size(awkward)];
    return mantissa(random) * (kind(random) < 5 ? 10 : std::pow(10.0, exponent(random)));
  };
  Mesh mesh;
  const std::uint32_t count = size(random);
  for (std::uint32_t i = 0; i < count; ++i)
    mesh.positions.push_back({coordinate(), coordinate(), coordinate()});
  mesh.triangles.push_back({0, 1, 2});
  for (std::uint32_t i = 1; i < count; ++i) mesh.triangles.push_back({i, (i + 1) % count, (i + 2) % count});
  for (std::uint32_t i = size(random); i > 0; --i) {
    const auto a = static_cast<std::uint32_t>(random() % count);
    mesh.triangles.push_back({a, (a + 1) % count, (a + 2) % count});
  }
  return mesh;
}

}  // namespace anamorph::testing
