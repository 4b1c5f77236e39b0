// The concrete shapes, for tests that set one up or look into one.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "optics/cone.h"
#include "optics/cylinder.h"
#include "optics/ellipsoid.h"
#include "optics/mesh_mirror.h"
#include "optics/optic.h"
#include "optics/paraboloid.h"
#include "optics/plane.h"
#include "optics/shape.h"
#include "optics/sphere.h"

namespace anamorph {

/// Two parallel mirrors: what comes from before the lower one leaves the upper one in the same direction.
///
///             / -->        the upper one, 5 above the lower one, at the origin; both are 2 x 2 and lean by 45 degrees
///         --> /
inline Optic makePeriscope() {
  const Vector x(1, 0, 0), up = glm::normalize(Vector(0, 1, 1));
  Optic optic;
  optic.parts.clear();
  for (const Point& c : {Point(0, 0, 0), Point(0, 0, 5)}) {
    optic.parts.push_back({OpticKind::mirror, PlaneMirror{{c - x - up, c + x - up, c + x + up, c - x + up}}});
  }
  return optic;
}

/// The shape as an S. Throws when it is another.
template <typename S>
const S& shapeAs(const Shape& shape) {
  const S* concrete = shape.as<S>();
  if (!concrete)
    throw std::runtime_error(std::string("expected a ") + S::name + ", got a " + shapeName(shape));
  return *concrete;
}

/// A mirror of triangles, as if they had been read from a file.
inline Shape meshMirror(SmoothMesh surface, const Placement& placement = {}) {
  return MeshMirror{{"mirror.obj", std::make_shared<const SmoothMesh>(std::move(surface)), {}}, placement};
}

/// Lets `change` work on the shape as an S.
template <typename S, typename Change>
void changeShape(Shape& shape, const Change& change) {
  S concrete = shapeAs<S>(shape);
  change(concrete);
  shape = std::move(concrete);
}

}  // namespace anamorph
