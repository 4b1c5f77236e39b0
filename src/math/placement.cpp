#include "math/placement.h"

namespace anamorph {

glm::dmat3 rotationMatrix(const Vector& rotationDegrees) {
  const auto turn = [](double angleDegrees, const Vector& a, const Vector& b, const Vector& axis, int first) {
    const double c = std::cos(radians(angleDegrees)), s = std::sin(radians(angleDegrees));
    glm::dmat3 m;
    m[first] = axis;
    m[(first + 1) % 3] = c * a + s * b;
    m[(first + 2) % 3] = -s * a + c * b;
    return m;
  };
  const Vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  return turn(rotationDegrees.z, x, y, z, 2) * turn(rotationDegrees.y, z, x, y, 1) *
         turn(rotationDegrees.x, y, z, x, 0);
}

// R = Rz(c) Ry(b) Rx(a). Once c is chosen the other two follow from what is left of the rotation, exactly and
// without dividing (Shoemake 1994, "Euler angle conversion"): it is near cos b = 0 that the usual three atan2
// lose digits.
Vector eulerDegrees(const glm::dmat3& r, const Vector& near) {
  const double cosine = std::hypot(r[0][0], r[0][1]);
  const double c = cosine > 1e-12 ? std::atan2(r[0][1], r[0][0]) : radians(near.z);
  const double cc = std::cos(c), sc = std::sin(c);
  const double b = std::atan2(-r[0][2], cc * r[0][0] + sc * r[0][1]);
  const double a = std::atan2(sc * r[2][0] - cc * r[2][1], cc * r[1][1] - sc * r[1][0]);
  const auto nearest = [&](const Vector& angles) {
    Vector result;
    for (int i = 0; i < 3; ++i) result[i] = near[i] + std::remainder(angles[i] - near[i], 360.0);
    return result;
  };
  const Vector first = nearest({degrees(a), degrees(b), degrees(c)});
  const Vector second = nearest({degrees(a) + 180, 180 - degrees(b), degrees(c) + 180});
  Vector best = lengthSquared(second - near) < lengthSquared(first - near) ? second : first;
  for (int i = 0; i < 3; ++i) best[i] = std::round(best[i] * 1e9) / 1e9 + 0.0;  // + 0.0: no -0
  return best;
}

PlacementMap::PlacementMap(const Placement& placement)
    : position_(placement.position),
      linear_(rotationMatrix(placement.rotationDegrees)),
      onlyMoves_(placement.rotationDegrees == Vector(0) && placement.scale == Vector(1)) {
  for (int i = 0; i < 3; ++i) linear_[i] *= placement.scale[i];
}

Point PlacementMap::operator()(const Point& p) const {
  return onlyMoves_ ? position_ + p : position_ + linear_ * p;
}

}  // namespace anamorph
