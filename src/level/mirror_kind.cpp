#include "level/mirror_kind.h"

#include "optics/shape_table.h"

namespace anamorph {

std::vector<std::string> mirrorKinds() {
  std::vector<std::string> names;
  for (const ShapeType& type : shapeTypes()) {
    if (!type.needsFile) names.emplace_back(type.name);
  }
  return names;
}

Shape mirrorOfKind(std::size_t kind, const Shape& old, const Point& eye) {
  const ShapeType& type = shapeTypes().at(kind);
  return kind == shapeIndex(old) || type.needsFile ? old : type.filling(extentOf(old), eye);
}

}  // namespace anamorph
