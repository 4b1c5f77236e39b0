#include "geometry/stl_reader.h"

#include <fmt/format.h>

#include <utility>

#include "base/error.h"
#include "geometry/file_text.h"
#include "geometry/mesh_assembly.h"
#include "geometry/stl_binary.h"
#include "geometry/stl_text.h"

namespace anamorph {
namespace {

constexpr Remark twiceTheSame{"1 triangle with two equal corners left out",
                              "{} triangles with two equal corners left out"};

// Binary files may begin with "solid" too, but have 0 bytes soon.
bool isText(std::string_view bytes) {
  if (isExactBinaryStl(bytes, bytes.size())) return false;
  std::string_view text = withoutPadding(bytes);
  const bool hasZero = text.substr(0, 512).find('\0') != std::string_view::npos;
  const std::string_view word = takeWordPastComments(text);
  return (isKeyword(word, "solid") || isKeyword(word, "facet")) && !hasZero;
}

// Triangles that welding leaves without a third corner.
void remarkDropped(const WeldedMesh& welded, std::size_t all, MeshRemarks& remarks) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < all; ++i) {
    if (kept < welded.triangleOf.size() && welded.triangleOf[kept] == i) {
      ++kept;
      continue;
    }
    remarks.add(twiceTheSame, [&] {
      return RemarkPlace{fmt::format("triangle {}", i + 1), "expected three different corners"};
    });
  }
}

}  // namespace

Mesh readStl(std::string_view bytes, MeshRemarks& remarks, const MeshLimits& limits) {
  const Mesh triangles =
      isText(bytes) ? readTextStl(bytes, remarks, limits) : readBinaryStl(bytes, remarks, limits);
  WeldedMesh welded = weldPositions(triangles);
  if (welded.mesh.triangles.size() < triangles.triangles.size()) {
    remarkDropped(welded, triangles.triangles.size(), remarks);
    leaveOutUnusedVertices(welded.mesh);
  }
  if (welded.mesh.triangles.empty())
    failWithoutTriangles(remarks, "a point cloud", welded.mesh.positions.size());
  if (welded.mesh.positions.size() > limits.maxVertices) {
    throw Error(fmt::format("expected at most {} vertices, got {}; --max-vertices raises the limit",
                            limits.maxVertices, welded.mesh.positions.size()),
                remarks.file());
  }
  return std::move(welded.mesh);
}

}  // namespace anamorph
