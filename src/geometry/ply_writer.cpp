#include "geometry/ply_writer.h"

#include <fmt/format.h>

#include "geometry/little_endian_file.h"

namespace anamorph {
namespace {

std::string header(const Mesh& mesh, const std::string& comment) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\n{}"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      comment.empty() ? "" : "comment " + comment + "\n", mesh.positions.size(), mesh.triangles.size());
}

void writeWhenLarge(AtomicFile& file, std::string& bytes) {
  if (bytes.size() < 1 << 20) return;
  file.write(bytes);
  bytes.clear();
}

}  // namespace

void writePly(AtomicFile& file, const Mesh& mesh, const std::string& comment) {
  std::string bytes = header(mesh, comment);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Point p = mesh.positions[i];
    for (int axis = 0; axis < 3; ++axis) appendLittleEndian(bytes, p[axis]);
    writeWhenLarge(file, bytes);
  }
  for (const Triangle& triangle : mesh.triangles) {
    appendLittleEndian(bytes, std::uint8_t{3});
    for (const std::uint32_t corner : triangle) appendLittleEndian(bytes, corner);
    writeWhenLarge(file, bytes);
  }
  file.write(bytes);
}

}  // namespace anamorph
