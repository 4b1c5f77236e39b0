#include "geometry/stl_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "geometry/little_endian_file.h"

namespace anamorph {
namespace {

void appendVector(std::string& bytes, const Vector& v) {
  for (int axis = 0; axis < 3; ++axis) appendLittleEndian(bytes, static_cast<float>(v[axis]));
}

void appendTriangle(std::string& bytes, const PointArray& points, const Triangle& triangle) {
  const Vector area = areaVector(points, triangle);
  const double length = glm::length(area);
  appendVector(bytes, length > 0 && std::isfinite(length) ? area / length : Vector{0});
  for (const std::uint32_t corner : triangle) appendVector(bytes, points[corner]);
  appendLittleEndian(bytes, std::uint16_t{0});
}

void checkFitsFloat(const PointArray& points, const std::string& name) {
  for (const auto* axis : {&points.x, &points.y, &points.z}) {
    for (const double value : *axis) {
      if (std::abs(value) > std::numeric_limits<float>::max()) {
        throw Error(fmt::format("cannot write: STL has no coordinates as large as {}", value), name);
      }
    }
  }
}

}  // namespace

void writeStl(AtomicFile& file, const Mesh& mesh, const std::string& comment, const std::string& name) {
  const std::size_t count = mesh.triangles.size();
  if (count == 0) throw Error("cannot write: STL needs at least one triangle", name);
  if (count > std::numeric_limits<std::uint32_t>::max())
    throw Error("cannot write: too many triangles for STL", name);
  checkFitsFloat(mesh.positions, name);

  // A header that began with "solid" would look like text to other programs.
  std::string bytes = "binary STL " + comment;
  bytes.resize(80, ' ');
  appendLittleEndian(bytes, static_cast<std::uint32_t>(count));
  for (const Triangle& triangle : mesh.triangles) {
    appendTriangle(bytes, mesh.positions, triangle);
    if (bytes.size() >= 1 << 20) {
      file.write(bytes);
      bytes.clear();
    }
  }
  file.write(bytes);
}

}  // namespace anamorph
