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
