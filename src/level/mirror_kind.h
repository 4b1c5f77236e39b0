// A mirror of another kind in the old one's place: what panels offer, and what a lesson's move can make of one.
#pragma once

#include <string>
#include <vector>

#include "optics/shape.h"

namespace anamorph {

/// The names of the shapes that a mirror can become at once, in the order of shapeTypes(): not those that need a file.
std::vector<std::string> mirrorKinds();

/// A mirror of another kind (its index in shapeTypes()) with the middle of the old one and
/// within its height and width; the same when it is of that kind already, and
/// when that kind needs a file.
///
/// Each shape says itself how it fills a room (ShapeType::filling): flat ones turn towards the eye, round ones stay
/// half as far from their middle as the eye is. Sound whatever the old one is.
Shape mirrorOfKind(std::size_t kind, const Shape& old, const Point& eye);

}  // namespace anamorph
