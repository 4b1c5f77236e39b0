// The concrete shapes, for tests that set one up or look into one.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "optics/cone.h"
#include "optics/cylinder.h"
#include "optics/plane.h"
#include "optics/shape.h"
#include "optics/sphere.h"

namespace anamorph {

/// The shape as an S. Throws when it is another.
template <typename S>
const S& shapeAs(const Shape& shape) {
  const S* concrete = shape.as<S>();
  if (!concrete)
    throw std::runtime_error(std::string("expected a ") + S::name + ", got a " + shapeName(shape));
  return *concrete;
}

/// Lets `change` work on the shape as an S.
template <typename S, typename Change>
void changeShape(Shape& shape, const Change& change) {
  S concrete = shapeAs<S>(shape);
  change(concrete);
  shape = std::move(concrete);
}

}  // namespace anamorph
