#include "geometry/stl_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "geometry/file_text.h"
#include "geometry/little_endian_file.h"

namespace anamorph {
namespace {

constexpr std::size_t headerSize = 84;    // 80 bytes of text, the number of triangles
constexpr std::size_t triangleSize = 50;  // normal, three corners, 2 bytes of attributes

void addTriangle(Mesh& mesh) {
  const auto count = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.triangles.push_back({count - 3, count - 2, count - 1});
}

Mesh readBinary(std::string_view bytes, const std::string& file, const MeshLimits& limits) {
  if (bytes.size() < headerSize) {
    throw Error(fmt::format("expected an STL file of at least {} bytes, got {}", headerSize, bytes.size()),
                file);
  }
  const std::size_t count = readLittleEndian<std::uint32_t>(bytes.data() + 80);
  if (count > (bytes.size() - headerSize) / triangleSize) {
    throw Error(fmt::format("expected {} bytes for {} triangles, got {}", headerSize + count * triangleSize,
                            count, bytes.size()),
                file);
  }
  if (count > limits.maxTriangles()) throw Error(limits.tooManyTriangles(), file);

  Mesh mesh;
  mesh.positions.reserve(3 * count);
  mesh.triangles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      const char* at = bytes.data() + headerSize + i * triangleSize + 12 + 12 * corner;
      const Point p{readLittleEndian<float>(at), readLittleEndian<float>(at + 4),
                    readLittleEndian<float>(at + 8)};
      if (!areCoordinates(p)) {
        throw Error(fmt::format("expected {}, got {} {} {}", threeCoordinates, p.x, p.y, p.z), file,
                    fmt::format("triangle {}", i + 1));
      }
      mesh.positions.push_back(p);
    }
    addTriangle(mesh);
  }
  return mesh;
}

// Keywords may be written in capitals.
bool isKeyword(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

// The words of a text STL file: solid NAME { facet normal N outer loop vertex P ... endloop endfacet }
// endsolid NAME. Where lines end does not matter, except for the names.
class StlText {
 public:
  StlText(std::string_view bytes, const std::string& file, const MeshLimits& limits)
      : bytes_(bytes), rest_(bytes), file_(file), limits_(limits) {}

  Mesh read() {
    while (!trimmed(rest_).empty()) {
      expect("solid");
      skipLine();
      readFacets();
    }
    return std::move(mesh_);
  }

 private:
  void readFacets() {
    while (true) {
      const std::string_view word = takeWord(rest_);
      if (isKeyword(word, "endsolid")) break;
      if (!isKeyword(word, "facet")) fail("\"facet\" or \"endsolid\"", word);
      readFacet();
    }
    skipLine();
  }

  void readFacet() {
    expect("normal");
    for (int i = 0; i < 3; ++i) takeWord(rest_);  // some programs write nan here
    expect("outer");
    expect("loop");
    for (int corner = 0; corner < 3; ++corner) {
      expect("vertex");
      readPoint();
    }
    expect("endloop");
    expect("endfacet");
    if (mesh_.triangles.size() == limits_.maxTriangles()) throw Error(limits_.tooManyTriangles(), file_);
    addTriangle(mesh_);
  }

  void readPoint() {
    Point p;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = takeWord(rest_);
      const auto coordinate = parseCoordinate(word);
      if (!coordinate) fail(threeCoordinates, word);
      p[axis] = *coordinate;
    }
    mesh_.positions.push_back(p);
  }

  void expect(std::string_view keyword) {
    const std::string_view word = takeWord(rest_);
    if (!isKeyword(word, keyword)) fail(inQuotes(keyword), word);
  }

  void skipLine() { rest_.remove_prefix(std::min(rest_.find_first_of("\r\n"), rest_.size())); }

  [[noreturn]] void fail(std::string_view expected, std::string_view word) const {
    throw Error(fmt::format("expected {}, got {}", expected, inQuotesOrEnd(word)), file_,
                lineAt(bytes_, static_cast<std::size_t>(word.data() - bytes_.data())));
  }

  std::string_view bytes_, rest_;
  const std::string& file_;
  const MeshLimits& limits_;
  Mesh mesh_;
};

// Binary files may begin with "solid" too; no text has a 0 byte.
bool isText(std::string_view bytes) {
  std::string_view rest = bytes;
  return isKeyword(takeWord(rest), "solid") && bytes.find('\0') == std::string_view::npos;
}

}  // namespace

bool looksLikeStl(std::string_view bytes) {
  return isText(bytes) || bytes.find('\0') != std::string_view::npos;
}

Mesh readStl(std::string_view bytes, const std::string& file, const MeshLimits& limits) {
  const Mesh triangles =
      isText(bytes) ? StlText(bytes, file, limits).read() : readBinary(bytes, file, limits);
  Mesh mesh = weldPositions(triangles).mesh;
  if (mesh.positions.size() > limits.maxVertices) {
    throw Error(fmt::format("expected at most {} vertices, got {}; --max-vertices raises the limit",
                            limits.maxVertices, mesh.positions.size()),
                file);
  }
  return mesh;
}

}  // namespace anamorph
