#include "geometry/stl_binary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "geometry/file_text.h"
#include "geometry/little_endian_file.h"

namespace anamorph {
namespace {

constexpr std::size_t headerSize = 84;    // 80 bytes of text, the number of triangles
constexpr std::size_t triangleSize = 50;  // normal, three corners, 2 bytes of attributes

constexpr Remark badTriangles{"1 triangle with a corner that is not three numbers left out",
                              "{} triangles with a corner that is not three numbers left out"};

std::size_t claimedTriangles(std::string_view head) {
  return readLittleEndian<std::uint32_t>(head.data() + 80);
}

Point cornerAt(const char* triangle, int corner) {
  const char* at = triangle + 12 + 12 * corner;
  return {readLittleEndian<float>(at), readLittleEndian<float>(at + 4), readLittleEndian<float>(at + 8)};
}

// Whether bytes behind the last triangle may be one more. Text, read as numbers, is far too large or too small.
bool looksLikeTriangle(const char* bytes) {
  constexpr double smallest = 1e-15;
  for (int corner = 0; corner < 3; ++corner) {
    const Point p = cornerAt(bytes, corner);
    for (int axis = 0; axis < 3; ++axis) {
      const double size = std::abs(p[axis]);
      if (std::isfinite(size) && size != 0 && (size < smallest || size > maxCoordinate)) return false;
    }
  }
  return true;
}

// Triangles that a head knows nothing of: those that fill the file, or else as long as they look like some.
std::size_t trianglesBeyond(std::string_view beyond) {
  const std::size_t most = beyond.size() / triangleSize;
  if (isPadding(beyond)) return 0;
  std::size_t count = 0;
  while (count < most && looksLikeTriangle(beyond.data() + count * triangleSize)) ++count;
  return count > 0 && beyond.size() % triangleSize == 0 ? most : count;
}

std::size_t countTriangles(std::string_view bytes, MeshRemarks& remarks) {
  const std::size_t claimed = claimedTriangles(bytes);
  const std::string_view data = bytes.substr(headerSize);
  std::size_t count = data.size() / triangleSize;
  if (claimed <= count) {
    count = claimed + trianglesBeyond(data.substr(claimed * triangleSize));
  } else if (count == 0 || (data.size() % triangleSize != 0 &&
                            claimed != std::numeric_limits<std::uint32_t>::max())) {  // -1: it was not known
    throw Error(fmt::format("expected {} bytes for {} triangles, got {}", headerSize + claimed * triangleSize,
                            claimed, bytes.size()),
                remarks.file());
  }
  if (count != claimed) {
    remarks.say(
        {}, fmt::format("the head claims {} triangles, the file holds {}, which are read", claimed, count));
  }
  const std::string_view rest = data.substr(count * triangleSize);
  if (!isPadding(rest)) remarks.say({}, fmt::format("{} bytes after the last triangle skipped", rest.size()));
  return count;
}

}  // namespace

bool isExactBinaryStl(std::string_view head, std::size_t fileSize) {
  if (head.size() < headerSize || fileSize <= headerSize) return false;
  return fileSize - headerSize == claimedTriangles(head) * triangleSize;
}

Mesh readBinaryStl(std::string_view bytes, MeshRemarks& remarks, const MeshLimits& limits) {
  if (bytes.size() < headerSize) {
    throw Error(fmt::format("expected an STL file of at least {} bytes, got {}", headerSize, bytes.size()),
                remarks.file());
  }
  const std::size_t count = countTriangles(bytes, remarks);
  if (count > limits.maxTriangles()) throw Error(limits.tooManyTriangles(), remarks.file());

  Mesh mesh;
  mesh.positions.reserve(3 * count);
  mesh.triangles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const char* triangle = bytes.data() + headerSize + i * triangleSize;
    const std::array<Point, 3> corners{cornerAt(triangle, 0), cornerAt(triangle, 1), cornerAt(triangle, 2)};
    const auto bad = std::find_if_not(corners.begin(), corners.end(), areCoordinates);
    if (bad != corners.end()) {
      remarks.add(badTriangles, [&] {
        return RemarkPlace{
            fmt::format("triangle {}", i + 1),
            fmt::format("expected {}, got {} {} {}", threeCoordinates, bad->x, bad->y, bad->z)};
      });
      continue;
    }
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Point& p : corners) mesh.positions.push_back(p);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

}  // namespace anamorph
