#include "geometry/mesh_limits.h"

#include <fmt/format.h>

namespace anamorph {

std::string MeshLimits::tooManyTriangles() const {
  return fmt::format("expected at most {} triangles; --max-vertices raises the limit", maxTriangles());
}

}  // namespace anamorph
