#include "geometry/ply_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "geometry/file_text.h"
#include "geometry/ply_header.h"
#include "geometry/ply_values.h"
#include "geometry/polygon.h"

namespace anamorph {
namespace {

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::string& file, const MeshLimits& limits)
      : file_(file),
        limits_(limits),
        header_(readPlyHeader(bytes, file)),
        values_(bytes.substr(header_.size), header_.format) {}

  Mesh read() {
    vertexCount_ = countOf("vertex", limits_.maxVertices, "vertices");
    if (vertexCount_ == 0) throw Error("expected at least one vertex, got 0", file_);
    countOf("face", limits_.maxTriangles(), "faces");
    for (const PlyElement& element : header_.elements) readElement(element);
    Mesh mesh;
    mesh.triangles = triangulate(positions_, polygons_);
    mesh.positions = std::move(positions_);
    return mesh;
  }

 private:
  std::uint64_t countOf(std::string_view name, std::size_t limit, std::string_view plural) const {
    for (const PlyElement& element : header_.elements) {
      if (element.name != name) continue;
      if (element.count <= limit) return element.count;
      throw Error(fmt::format("expected at most {} {}, got {}; --max-vertices raises the limit", limit,
                              plural, element.count),
                  file_);
    }
    throw Error(fmt::format("expected an element {}, got none", name), file_);
  }

  void readElement(const PlyElement& element) {
    const std::size_t most = values_.mostRows(element);
    if (element.count > most) {
      throw Error(fmt::format("expected {} rows of element {}, got the end of the file after at most {}",
                              element.count, inQuotes(element.name), most),
                  file_);
    }
    element_ = &element;
    if (element.name == "vertex") {
      readVertices();
    } else if (element.name == "face") {
      readFaces();
    } else if (!element.properties.empty()) {  // billions of empty rows would take their time
      for (row_ = 0; row_ < element.count; ++row_) {
        for (const PlyProperty& property : element.properties) skip(property);
      }
    }
  }

  void readVertices() {
    const std::array<std::size_t, 3> axes{findScalar("x"), findScalar("y"), findScalar("z")};
    positions_.reserve(element_->count);
    for (row_ = 0; row_ < element_->count; ++row_) {
      Point p;
      for (std::size_t k = 0; k < element_->properties.size(); ++k) {
        const auto axis = std::find(axes.begin(), axes.end(), k) - axes.begin();
        if (axis == 3) {
          skip(element_->properties[k]);
        } else {
          p[static_cast<int>(axis)] = next(element_->properties[k].type);
        }
      }
      if (!areCoordinates(p)) fail(fmt::format("expected {}, got {} {} {}", threeCoordinates, p.x, p.y, p.z));
      positions_.push_back(p);
    }
  }

  void readFaces() {
    const std::size_t indices = findIndexList();
    for (row_ = 0; row_ < element_->count; ++row_) {
      for (std::size_t k = 0; k < element_->properties.size(); ++k) {
        if (k == indices) {
          readPolygon(element_->properties[k]);
        } else {
          skip(element_->properties[k]);
        }
      }
    }
  }

  void readPolygon(const PlyProperty& property) {
    const std::size_t size = nextCount(*property.countType);
    if (const std::string problem = problemWithPolygon(polygons_, size, limits_); !problem.empty())
      fail(problem);
    for (std::size_t i = 0; i < size; ++i) {
      const double index = next(property.type);
      if (!(index >= 0 && index < static_cast<double>(vertexCount_)) || index != std::floor(index)) {
        fail(fmt::format("expected vertex indices from 0 to {}, got {}", vertexCount_ - 1, index));
      }
      polygons_.corners.push_back(static_cast<std::uint32_t>(index));
    }
    polygons_.sizes.push_back(static_cast<std::uint32_t>(size));
  }

  std::size_t findScalar(std::string_view name) const {
    return findProperty([&](const PlyProperty& p) { return p.name == name && !p.countType; },
                        fmt::format("a property {} of element vertex", name));
  }

  std::size_t findIndexList() const {
    return findProperty(
        [](const PlyProperty& p) {
          return (p.name == "vertex_indices" || p.name == "vertex_index") && p.countType;
        },
        "a property list vertex_indices of element face");
  }

  template <typename Predicate>
  std::size_t findProperty(const Predicate& isWanted, const std::string& what) const {
    const auto& all = element_->properties;
    const auto found = std::find_if(all.begin(), all.end(), isWanted);
    if (found == all.end()) throw Error(fmt::format("expected {}, got none", what), file_);
    return static_cast<std::size_t>(found - all.begin());
  }

  double next(PlyType type) {
    const std::optional<double> value = values_.next(type);
    if (!value) fail(fmt::format("expected a number, got {}", values_.lastValue()));
    return *value;
  }

  std::size_t nextCount(PlyType type) {
    const double count = next(type);
    constexpr double largest = std::numeric_limits<std::uint32_t>::max();
    if (!(count >= 0 && count <= largest)) fail(fmt::format("expected the length of a list, got {}", count));
    return static_cast<std::size_t>(count);
  }

  void skip(const PlyProperty& property) {
    const std::size_t count = property.countType ? nextCount(*property.countType) : 1;
    if (!values_.skip(property.type, count)) fail("expected more values, got the end of the file");
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw Error(message, file_, fmt::format("{} {}", element_->name, row_));
  }

  const std::string& file_;
  const MeshLimits& limits_;
  PlyHeader header_;
  PlyValues values_;
  std::uint64_t vertexCount_ = 0;
  const PlyElement* element_ = nullptr;  // the one that is being read,
  std::uint64_t row_ = 0;                // and its row
  PointArray positions_;
  PolygonSoup polygons_;
};

}  // namespace

Mesh readPly(std::string_view bytes, const std::string& file, const MeshLimits& limits) {
  return PlyReader(bytes, file, limits).read();
}

}  // namespace anamorph
