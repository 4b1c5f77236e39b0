// The shapes that there are, by their names: what files, panels, lessons and tests choose from.
#pragma once

#include <vector>

#include "optics/shape.h"

namespace anamorph {

struct ShapeType {
  const char* name;   ///< in files: "plane"
  const char* label;  ///< in panels, English: "Plane"
  Shape standard;     ///< with its usual fields
  int since;          ///< the version of the level format that knows it first
  bool needsFile;     ///< is nothing without a file that somebody chooses
  /// One that fills a room, sound and seen from outside by the eye.
  Shape (*filling)(const ShapeExtent& room, const Point& eye);
};

template <typename S>
ShapeType shapeType() {
  int since = 1;
  if constexpr (requires { S::since; }) since = S::since;
  constexpr bool needsFile = requires {
    S::needsFile;
  };
  return {S::name,    S::label,
          Shape(S{}), since,
          needsFile,  [](const ShapeExtent& room, const Point& eye) { return Shape(S::filling(room, eye)); }};
}

/// All of them, in the order in which they are offered.
const std::vector<ShapeType>& shapeTypes();

/// Their names in files, in that order.
std::vector<const char*> shapeNames();

/// Which of them a shape is.
std::size_t shapeIndex(const Shape& shape);

/// Adds one more, for as long as the program runs: for tests.
void registerShape(ShapeType type);

}  // namespace anamorph
