// Three neighbouring rays from the eye as they leave the optic: how large the thin bundle between them is at each
// distance beyond it (method-optics section 5).
//
//   D0 D1 D2 from the eye            spread(d) = ((q1 + d r1) x (q2 + d r2)) . R / det(D0, D1, D2)
//     \ | /                          q1 = Q1 - Q0, r1 = R1 - R0, ...; R their mean.
//    --Q0Q1Q2-- optic
//      \|/                           A quadratic in d. Where it is 0 the rays cross: its positive roots are the two
//       *  focus                     focal points of the bundle. Where it is negative, left and right are exchanged; one
//                                    reflection does so, too.
//      /|\ R
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "anamorphosis/vertex_map.h"

namespace anamorph {

/// Where a ray from the eye leaves the optic.
struct ExitRay {
  Direction sent{0};    ///< unit, at the eye
  Point exit{0};        ///< the last point on the optic
  Direction onward{0};  ///< unit, from there
  double distance = 0;  ///< how far along it the sculpture is, scene units
};

/// Of the ray from the map's eye towards a point; nothing when it does not come through the optic.
std::optional<ExitRay> exitRayTowards(const VertexMap& map, const Point& target);

class RayBundle {
 public:
  explicit RayBundle(const std::array<ExitRay, 3>& rays);

  /// As large as it is at the eye, det(D0, D1, D2); negative for clockwise rays.
  double sizeAtEye() const { return atEye_; }
  /// Whether the three rays lie nearly in one plane, so that the signs mean nothing.
  bool edgeOn() const { return edgeOn_; }
  /// Of the sign of spread(d), d in scene units.
  double spread(double distance) const;
  /// The mean of its rays' distances.
  double distance() const { return distance_; }
  /// The distances > 0 beyond the optic at which the rays cross, rising; both are the same in a double focus.
  std::vector<double> foci() const;

 private:
  friend std::optional<RayBundle> bundleAround(const VertexMap& map, const ExitRay& ray, const Point& target,
                                               double step);
  // Two sides of the bundle: how its rays differ at the eye, on the optic and beyond it.
  struct Side {
    Vector sent, exit, onward;
  };
  static Side between(const ExitRay& from, const ExitRay& to);
  RayBundle(const Side& one, const Side& other, const Direction& sent, const Direction& onward,
            double distance);

  double atEye_, distance_;
  double constant_, linear_, square_;  // of the spread, without the division
  bool edgeOn_;
};

/// The bundle around the ray from the eye towards a point: of four rays beside it, `step` radians away, so that the
/// differences are right to its square. Nothing when one of them does not come through the optic.
std::optional<RayBundle> bundleAround(const VertexMap& map, const ExitRay& ray, const Point& target,
                                      double step = 1e-5);
std::optional<RayBundle> bundleAround(const VertexMap& map, const Point& target, double step = 1e-5);

}  // namespace anamorph
