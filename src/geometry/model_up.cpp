#include "geometry/model_up.h"

#include <algorithm>

namespace anamorph {

std::optional<ModelUp> findModelUp(std::string_view name) {
  const auto at = std::find(modelUpNames.begin(), modelUpNames.end(), name);
  if (at == modelUpNames.end()) return std::nullopt;
  return static_cast<ModelUp>(at - modelUpNames.begin());
}

glm::dmat3 uprightRotation(ModelUp up) {
  const Vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  switch (up) {  // where x, y and z go
    case ModelUp::z:
      break;
    case ModelUp::y:
      return {x, z, -y};
    case ModelUp::minusY:
      return {x, -z, y};
    case ModelUp::x:
      return {z, y, -x};
  }
  return {x, y, z};
}

Mesh standUp(Mesh mesh, ModelUp up) {
  if (up == ModelUp::z) return mesh;
  const glm::dmat3 turn = uprightRotation(up);
  mesh.positions = mapPoints(mesh.positions, [&](const Point& p) { return turn * p; });
  return mesh;
}

}  // namespace anamorph
