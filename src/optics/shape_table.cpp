#include "optics/shape_table.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/check.h"
#include "optics/cone.h"
#include "optics/cylinder.h"
#include "optics/ellipsoid.h"
#include "optics/extrusion.h"
#include "optics/mesh_mirror.h"
#include "optics/paraboloid.h"
#include "optics/patch.h"
#include "optics/plane.h"
#include "optics/revolution.h"
#include "optics/sphere.h"

namespace anamorph {
namespace {

std::vector<ShapeType>& table() {
  static std::vector<ShapeType> types{shapeType<PlaneMirror>(),      shapeType<CylinderMirror>(),
                                      shapeType<SphereMirror>(),     shapeType<ConeMirror>(),
                                      shapeType<EllipsoidMirror>(),  shapeType<ParaboloidMirror>(),
                                      shapeType<RevolutionMirror>(), shapeType<ExtrusionMirror>(),
                                      shapeType<PatchMirror>(),      shapeType<MeshMirror>()};
  return types;
}

}  // namespace

Shape::Shape() : Shape(PlaneMirror{}) {}

const std::vector<ShapeType>& shapeTypes() {
  return table();
}

std::vector<const char*> shapeNames() {
  std::vector<const char*> names;
  for (const ShapeType& type : table()) names.push_back(type.name);
  return names;
}

std::size_t shapeIndex(const Shape& shape) {
  const auto found = std::find_if(table().begin(), table().end(), [&](const ShapeType& type) {
    return std::string_view(type.name) == shapeName(shape);
  });
  CHECK(found != table().end());
  return static_cast<std::size_t>(found - table().begin());
}

void registerShape(ShapeType type) {
  table().push_back(std::move(type));
}

}  // namespace anamorph
