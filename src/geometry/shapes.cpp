#include "geometry/shapes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "base/check.h"
#include "geometry/block_shape.h"
#include "geometry/lathe.h"

namespace anamorph {
namespace {

using ProfilePoint = glm::dvec2;  // (radius, z)

std::vector<ProfilePoint> halfCircle(double radius, int steps) {
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= steps; ++i) {
    const double angle = pi * i / steps;
    profile.emplace_back(radius * std::sin(angle), -radius * std::cos(angle));
  }
  profile.front().x = profile.back().x = 0;
  return profile;
}

// A centre line and the frame that travels along it; along, outward and sideways are perpendicular.
struct KnotPoint {
  Point position;
  Direction outward;   // away from the core of the torus
  Direction sideways;  // along x outward
};

// The frame comes from the torus, on which the knot lies: it is the same after a full turn, so there is no
// seam.
KnotPoint knotAt(int p, int q, double angle) {
  constexpr double coreRadius = 1, windingRadius = 0.45;
  const double turn = p * angle, wind = q * angle;
  const Direction radial{std::cos(turn), std::sin(turn), 0};
  const Direction around{-std::sin(turn), std::cos(turn), 0};
  const Direction up{0, 0, 1};
  const double distance = coreRadius + windingRadius * std::cos(wind);
  const Direction outward = std::cos(wind) * radial + std::sin(wind) * up;
  const Vector along =
      p * distance * around + q * windingRadius * (std::cos(wind) * up - std::sin(wind) * radial);
  return {distance * radial + windingRadius * std::sin(wind) * up, outward,
          glm::normalize(glm::cross(along, outward))};
}

// Profile curves: arcs joined by straight lines.
struct Arc {
  ProfilePoint centre;
  glm::dvec2 radii;
  double fromDegrees, toDegrees;  // 0 points outwards, 90 up
};

void appendArc(std::vector<ProfilePoint>& profile, const Arc& arc, double stepLength) {
  const double angle = std::abs(radians(arc.toDegrees - arc.fromDegrees));
  const int steps =
      std::max(3, static_cast<int>(std::ceil(angle * std::max(arc.radii.x, arc.radii.y) / stepLength)));
  for (int i = 0; i <= steps; ++i) {
    const double a = radians(arc.fromDegrees + (arc.toDegrees - arc.fromDegrees) * i / steps);
    profile.push_back(arc.centre + arc.radii * glm::dvec2(std::cos(a), std::sin(a)));
  }
}

// After a turned Staunton pawn, 1 high.
const Arc pawnArcs[] = {
    {{0.290, 0.040}, {0.040, 0.040}, -90, 0},    // foot
    {{0.270, 0.100}, {0.060, 0.060}, 0, 70},     // rounded rim of the base
    {{0.225, 0.190}, {0.035, 0.032}, -80, 80},   // ring
    {{0.375, 0.580}, {0.270, 0.410}, 240, 180},  // the body narrows into the neck
    {{0.150, 0.610}, {0.055, 0.028}, -80, 80},   // collar
    {{0.000, 0.815}, {0.185, 0.185}, -62, 90},   // head
};

}  // namespace

Mesh makeBox(const Vector& size, int segments) {
  CHECK(size.x > 0 && size.y > 0 && size.z > 0);
  const auto ends = [](double length) { return std::vector<double>{-length / 2, length / 2}; };
  return makeBlockShape(
      {ends(size.x), ends(size.y), ends(size.z)}, [](const auto&) { return true; }, segments);
}

Mesh makeSphere(double radius, int segments) {
  CHECK(radius > 0);
  return makeLathe(halfCircle(radius, std::max(2, segments / 2)), segments);
}

Mesh makeTorusKnot(int p, int q, double tubeRadius, int segments, int sides) {
  CHECK(std::gcd(p, q) == 1 && tubeRadius > 0 && segments >= 3 && sides >= 3);
  Mesh mesh;
  for (int i = 0; i < segments; ++i) {
    const KnotPoint knot = knotAt(p, q, 2 * pi * i / segments);
    for (int j = 0; j < sides; ++j) {
      const double angle = 2 * pi * j / sides;
      mesh.positions.push_back(
          knot.position + tubeRadius * (std::cos(angle) * knot.outward + std::sin(angle) * knot.sideways));
    }
  }
  const auto vertex = [&](int i, int j) {
    return static_cast<std::uint32_t>(i % segments * sides + j % sides);
  };
  for (int i = 0; i < segments; ++i) {
    for (int j = 0; j < sides; ++j) {
      const std::uint32_t a = vertex(i, j), b = vertex(i, j + 1), c = vertex(i + 1, j + 1),
                          d = vertex(i + 1, j);
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  mesh = unitize(std::move(mesh));
  mesh.positions = mapPoints(mesh.positions, [](const Point& point) { return 2.0 * point; });
  return mesh;
}

Mesh makeLetterF(double height, int segments) {
  CHECK(height > 0);
  // In fifths of the height: the stem and both arms are one wide, the upper arm ends at 3, the lower one
  // at 2.5.
  const double unit = height / 5;
  const auto times = [&](std::vector<double> places) {
    for (double& place : places) place *= unit;
    return places;
  };
  const auto isSolid = [](const std::array<int, 3>& block) {
    const bool stem = block[0] == 0, upperArm = block[2] == 3, lowerArm = block[2] == 1 && block[0] == 1;
    return stem || upperArm || lowerArm;
  };
  return makeBlockShape({times({-1.5, -0.5, 1, 1.5}), times({-0.5, 0.5}), times({-2.5, -0.5, 0.5, 1.5, 2.5})},
                        isSolid, segments);
}

Mesh makePawn(double height, int segments) {
  CHECK(height > 0);
  const double widest = 0.33;
  const double stepLength = 2 * pi * widest / segments;
  std::vector<ProfilePoint> profile{{0, 0}};
  for (const Arc& arc : pawnArcs) appendArc(profile, arc, stepLength);
  profile.back().x = 0;
  for (ProfilePoint& point : profile) point = height * (point - ProfilePoint(0, 0.5));
  return makeLathe(profile, segments);
}

}  // namespace anamorph
