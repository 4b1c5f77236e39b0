#include "geometry/obj_reader.h"

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <optional>
#include <streambuf>
#include <utility>

#include "base/error.h"
#include "geometry/file_text.h"
#include "geometry/mesh_assembly.h"
#include "geometry/normals.h"
#include "geometry/polygon.h"

namespace anamorph {
namespace {

constexpr Remark flatVertices{"1 vertex of two numbers, taken to lie at z = 0",
                              "{} vertices of two numbers, taken to lie at z = 0"};
constexpr Remark unreadFaces{"1 face that is not understood left out",
                             "{} faces that are not understood left out"};
constexpr Remark curves{"1 line, point or curve left out", "{} lines, points or curves left out"};
constexpr Remark freeForms{"1 free-form surface left out", "{} free-form surfaces left out"};

constexpr Remark noNormals{"1 corner without a normal of its own; it has that of its faces",
                           "{} corners without normals of their own; they have those of their faces"};

constexpr std::uint32_t noNormal = std::numeric_limits<std::uint32_t>::max();

bool startsWithKeyword(std::string_view line, char keyword) {
  return !line.empty() && line[0] == keyword && (line.size() == 1 || isBlank(line[1]));
}

// The corners of a face's line; nothing for another line.
std::optional<std::string_view> faceText(std::string_view line) {
  if (startsWithKeyword(line, 'f')) return line.substr(1);
  if (line.starts_with("fo") && startsWithKeyword(line.substr(1), 'o')) return line.substr(2);
  return std::nullopt;
}

// tinyobj uses atoi, which makes 0 of letters and wraps silently above 2^31: only lines it cannot misread
// reach it.
bool isFaceText(std::string_view text) {
  constexpr int mostDigits = 9;
  int digits = 0;
  for (const char c : text) {
    const bool isDigit = c >= '0' && c <= '9';
    digits = isDigit ? digits + 1 : 0;
    if (digits > mostDigits || !(isDigit || c == '/' || c == ' ' || c == '-' || c == '\t' || c == '\r'))
      return false;
  }
  return true;
}

// Corners as tinyobj knows them of such as +3 and 3.0, which other programs read.
std::string plainFaceText(std::string_view text) {
  std::string plain;
  for (std::string_view word; !(word = takeWord(text)).empty();) {
    if (word[0] == '+') word.remove_prefix(1);
    const std::size_t point = std::min(word.find('.'), word.size());
    if (word.find_first_not_of('0', point + (point < word.size() ? 1 : 0)) == std::string_view::npos)
      word = word.substr(0, point);
    plain.append(" ").append(word);
  }
  return plain;
}

// The text as tinyobj gets it. tinyobj knows the syntax of faces; its numbers, though, are off by some units
// in the last place, and it makes 0 of what is no number. So the `v` lines are read here on the way and only
// the `f` lines handed on, one at a time: when tinyobj reports a face, the vertices above it have been read,
// which is what negative indices count from.
class ObjText : public std::streambuf {
 public:
  ObjText(std::string_view bytes, MeshRemarks& remarks, const MeshLimits& limits, bool withNormals)
      : lines_(bytes), remarks_(remarks), limits_(limits), withNormals_(withNormals) {}

  void addFace(const tinyobj::index_t* corners, int count) {
    const auto size = static_cast<std::size_t>(count);
    if (size < 3) return leaveOut(shortFaces, fmt::format("expected at least three corners, got {}", size));
    if (const std::string limit = limitPassedBy(polygons, size, limits_); !limit.empty()) fail(limit);
    const std::size_t before = polygons.corners.size();
    for (std::size_t i = 0; i < size; ++i) {
      const int index = corners[i].vertex_index;
      if (!isPossible(index)) {
        polygons.corners.resize(before);
        if (withNormals_) polygons.normals.resize(before);
        return leaveOut(badIndices, problemWith(index));
      }
      polygons.corners.push_back(resolve(index, positions.size()));
      if (withNormals_) polygons.normals.push_back(normalAt(corners[i].normal_index));
    }
    polygons.sizes.push_back(static_cast<std::uint32_t>(size));
  }

  PointArray positions, normals;  // 0: a normal that is none
  PolygonSoup polygons;

 protected:
  int_type underflow() override {
    for (std::string_view line; lines_.next(line);) {
      while (!line.empty() && isBlank(line[0])) line.remove_prefix(1);
      if (startsWithKeyword(line, 'v')) {
        addVertex(lines_.continued(line).substr(1));
      } else if (faceText(line)) {
        if (prepareFace(*faceText(lines_.continued(line)))) return handOn();
      } else if (withNormals_ && line.starts_with("vn") && startsWithKeyword(line.substr(1), 'n')) {
        addNormal(lines_.continued(line).substr(2));
      } else {
        remarkOther(line);
      }
    }
    return traits_type::eof();
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw Error(message, remarks_.file(), where()); }

  std::string where() const { return fmt::format("line {}", lines_.number()); }

  void remark(const Remark& kind, const std::string& problem = {}) {
    remarks_.add(kind, [&] { return RemarkPlace{where(), problem}; });
  }

  void leaveOut(const Remark& kind, const std::string& problem) {
    remark(kind, problem);
    polygons.sizes.push_back(0);
    ++polygons.empty;
  }

  // What follows the three coordinates (a weight, a colour) is skipped.
  void addVertex(std::string_view text) {
    if (positions.size() == limits_.maxVertices) {
      fail(fmt::format("expected at most {} vertices; --max-vertices raises the limit", limits_.maxVertices));
    }
    std::string_view rest = text;
    const auto x = parseCoordinate(takeWord(rest));
    const auto y = parseCoordinate(takeWord(rest));
    const std::string_view third = takeWord(rest);
    const auto z = parseCoordinate(third);
    if (x && y && z) {
      positions.push_back({*x, *y, *z});
    } else if (x && y && (third.empty() || third[0] == '#')) {
      positions.push_back({*x, *y, 0});
      remark(flatVertices);
    } else {
      positions.push_back(noVertex());
      remarks_.add(badVertices, [&] {
        return RemarkPlace{where(), fmt::format("expected {}, got {}{}", threeCoordinates,
                                                inQuotes(trimmed(text)), decimalCommaHint(text))};
      });
    }
  }

  void addNormal(std::string_view text) {
    const auto x = parseNumber(takeWord(text)), y = parseNumber(takeWord(text)),
               z = parseNumber(takeWord(text));
    const Vector normal = x && y && z ? Vector(*x, *y, *z) : Vector(0);
    const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    normals.push_back(largest > 0 ? glm::normalize(normal / largest) : Vector(0));
  }

  // Puts a face into line_ for tinyobj, unless it is left out at once.
  bool prepareFace(std::string_view text) {
    text = text.substr(0, text.find('#'));
    if (isFaceText(text)) {
      line_.assign("f").append(text);
    } else if (const std::string plain = plainFaceText(text); isFaceText(plain)) {
      line_.assign("f").append(plain);
    } else {
      leaveOut(unreadFaces,
               fmt::format("expected vertex indices such as 3 or 3/1/2, got {}", inQuotes(trimmed(text))));
      return false;
    }
    if (line_.find_first_of("0123456789/-") == std::string::npos) {
      leaveOut(shortFaces, "expected at least three corners, got 0");
      return false;
    }
    return true;
  }

  int_type handOn() {
    line_.push_back('\n');
    setg(line_.data(), line_.data(), line_.data() + line_.size());
    return traits_type::to_int_type(line_[0]);
  }

  // What else could have been meant to be seen.
  void remarkOther(std::string_view line) {
    constexpr std::string_view initials = "lpcs";
    if (line.empty() || initials.find(line[0]) == std::string_view::npos) return;
    const std::string_view keyword = takeWord(line);
    if (keyword == "l" || keyword == "p" || keyword == "curv") remark(curves);
    if (keyword == "surf") remark(freeForms);
  }

  // The file's index: 1 is the first vertex, -1 the last one so far. Whether a vertex with a larger index follows is
  // known only at the end.
  bool isPossible(int index) const {
    return index > 0 || (index < 0 && -index <= static_cast<std::int64_t>(positions.size()));
  }

  static std::uint32_t resolve(int index, std::size_t count) {
    return static_cast<std::uint32_t>(index > 0 ? index - 1 : static_cast<std::int64_t>(count) + index);
  }

  std::uint32_t normalAt(int index) const {
    const bool isOne = index > 0 || (index < 0 && -index <= static_cast<std::int64_t>(normals.size()));
    return isOne ? resolve(index, normals.size()) : noNormal;
  }

  std::string problemWith(int index) const {
    if (index == 0) return "expected vertex indices from 1 on, or negative ones, got 0";
    return fmt::format("expected a vertex above this line, got {} after {} vertices", index,
                       positions.size());
  }

  LineReader lines_;
  MeshRemarks& remarks_;
  const MeshLimits& limits_;
  const bool withNormals_;
  std::string line_;
};

// The line of the n-th face, found only when a message needs it.
std::string lineOfFace(std::string_view bytes, std::size_t n) {
  LineReader lines(bytes);
  for (std::string_view line; lines.next(line);) {
    if (faceText(trimmed(line)) && n-- == 0) break;
  }
  return fmt::format("line {}", lines.number());
}

// Corners that have no normal in the file get one from their faces.
void fillNormals(SmoothMesh& surface, MeshRemarks& remarks) {
  const auto isOne = [&](std::uint32_t n) {
    return n < surface.normals.size() && surface.normals[n] != Vector(0);
  };
  std::optional<SmoothMesh> own;
  const auto first = static_cast<std::uint32_t>(surface.normals.size());
  for (std::size_t t = 0; t < surface.corners.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& normal = surface.corners[t][i];
      if (isOne(normal)) continue;
      if (!own) own = withSmoothNormals(surface.mesh);
      normal = first + own->corners[t][i];
      remarks.add(noNormals, [] { return RemarkPlace{}; });
    }
  }
  for (std::size_t n = 0; own && n < own->normals.size(); ++n) surface.normals.push_back(own->normals[n]);
}

// `corners`: where to put the corners' normals, and `normals` what they are; null: they are not wanted.
Mesh read(std::string_view bytes, MeshRemarks& remarks, const MeshLimits& limits,
          std::vector<Triangle>* corners, PointArray* normals) {
  ObjText text(bytes, remarks, limits, normals != nullptr);
  std::istream stream(&text);
  stream.exceptions(std::ios::badbit);  // without it the stream keeps the Errors of ObjText to itself
  tinyobj::callback_t callbacks;
  callbacks.index_cb = [](void* data, tinyobj::index_t* face, int count) {
    static_cast<ObjText*>(data)->addFace(face, count);
  };
  tinyobj::LoadObjWithCallback(stream, callbacks, &text);

  Mesh mesh = assembleMesh(std::move(text.positions), std::move(text.polygons),
                           {1, [&](std::size_t face) { return lineOfFace(bytes, face); }}, remarks, corners);
  if (mesh.triangles.empty()) {
    const char* what = remarks.has(freeForms) ? "free-form surfaces"
                       : remarks.has(curves)  ? "lines or curves"
                                              : "a point cloud";
    failWithoutTriangles(remarks, what, mesh.positions.size());
  }
  if (normals) *normals = std::move(text.normals);
  return mesh;
}

}  // namespace

Mesh readObj(std::string_view bytes, MeshRemarks& remarks, const MeshLimits& limits) {
  return read(bytes, remarks, limits, nullptr, nullptr);
}

SmoothMesh readSmoothObj(std::string_view bytes, MeshRemarks& remarks, const MeshLimits& limits) {
  SmoothMesh surface;
  surface.mesh = read(bytes, remarks, limits, &surface.corners, &surface.normals);
  if (surface.normals.empty()) return withSmoothNormals(std::move(surface.mesh));
  fillNormals(surface, remarks);
  return surface;
}

}  // namespace anamorph
