#include "geometry/ply_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "geometry/file_text.h"
#include "geometry/mesh_assembly.h"
#include "geometry/ply_header.h"
#include "geometry/ply_values.h"
#include "geometry/polygon.h"

namespace anamorph {
namespace {

constexpr Remark badStripIndices{"1 triangle of a strip with an index that no vertex has left out",
                                 "{} triangles of strips with an index that no vertex has left out"};
constexpr Remark brokenStrips{"1 strip shorter than it says", "{} strips shorter than they say"};
constexpr Remark longRows{"1 row longer than the head says, the rest of it skipped",
                          "{} rows longer than the head says, the rest of them skipped"};

constexpr double noIndex = -1;

bool isSplats(const PlyElement& vertices) {
  return std::any_of(vertices.properties.begin(), vertices.properties.end(),
                     [](const PlyProperty& p) { return p.name.starts_with("f_dc_") || p.name == "rot_0"; });
}

class PlyReader {
 public:
  PlyReader(std::string_view bytes, MeshRemarks& remarks, const MeshLimits& limits)
      : remarks_(remarks),
        limits_(limits),
        header_(readPlyHeader(bytes, remarks)),
        values_(bytes.substr(header_.size), header_) {}

  Mesh read() {
    const PlyElement* vertices = find("vertex");
    if (!vertices) throw Error("expected an element vertex, got none", remarks_.file());
    checkCount(vertices, limits_.maxVertices, "vertices");
    vertexCount_ = vertices->count;
    if (vertexCount_ == 0) throw Error("expected at least one vertex, got 0", remarks_.file());
    checkCount(find("face"), limits_.maxTriangles(), "faces");
    for (const PlyElement& element : header_.elements) readElement(element);
    if (const std::string rest = values_.leftOver(); !rest.empty())
      remarks_.say({}, rest + " after the last row skipped");
    Mesh mesh = assembleMesh(std::move(positions_), std::move(polygons_),
                             {0, [&](std::size_t polygon) { return whereIs(polygon); }}, remarks_);
    if (mesh.triangles.empty()) {
      failWithoutTriangles(remarks_, isSplats(*vertices) ? "Gaussian splats, a point cloud" : "a point cloud",
                           mesh.positions.size());
    }
    return mesh;
  }

 private:
  const PlyElement* find(std::string_view name) const {
    for (const PlyElement& element : header_.elements) {
      if (element.name == name) return &element;
    }
    return nullptr;
  }

  void checkCount(const PlyElement* element, std::size_t limit, std::string_view plural) const {
    if (!element || element->count <= limit) return;
    throw Error(fmt::format("expected at most {} {}, got {}; --max-vertices raises the limit", limit, plural,
                            element->count),
                remarks_.file());
  }

  void readElement(const PlyElement& element) {
    const std::size_t most = values_.mostRows(element);
    if (element.count > most) {
      throw Error(fmt::format("expected {} rows of element {}, got the end of the file after at most {}",
                              element.count, inQuotes(element.name), most),
                  remarks_.file());
    }
    element_ = &element;
    if (element.name == "vertex") {
      readVertices();
    } else if (element.name == "face") {
      readLists(&PlyReader::readPolygon);
    } else if (element.name == "tristrips") {
      readLists(&PlyReader::readStrip);
    } else if (!element.properties.empty()) {  // billions of empty rows would take their time
      forEachRow([&] {
        for (const PlyProperty& property : element.properties) skip(property);
      });
    }
  }

  template <typename ReadRow>
  void forEachRow(const ReadRow& readRow) {
    for (row_ = 0; row_ < element_->count; ++row_) {
      problem_.clear();
      readRow();
      if (!values_.endRow()) remarks_.add(longRows, [&] { return RemarkPlace{where(), {}}; });
    }
  }

  void readVertices() {
    const std::array<std::size_t, 3> axes{findScalar("x"), findScalar("y"), findScalar("z")};
    positions_.reserve(element_->count);
    forEachRow([&] {
      Point p;
      for (std::size_t k = 0; k < element_->properties.size(); ++k) {
        const auto axis = std::find(axes.begin(), axes.end(), k) - axes.begin();
        if (axis == 3) {
          skip(element_->properties[k]);
        } else {
          p[static_cast<int>(axis)] = next(element_->properties[k].type);
        }
      }
      addVertex(p);
    });
  }

  void addVertex(const Point& p) {
    if (areCoordinates(p)) return positions_.push_back(p);
    positions_.push_back(noVertex());
    remarks_.add(badVertices, [&] {
      return RemarkPlace{where(), problem_.empty() ? fmt::format("expected {}, got {} {} {}",
                                                                 threeCoordinates, p.x, p.y, p.z)
                                                   : problem_};
    });
  }

  void readLists(void (PlyReader::*readList)(const PlyProperty&)) {
    const std::size_t indices = findIndexList();
    if (element_->name == "face") firstFace_ = polygons_.sizes.size();
    forEachRow([&] {
      for (std::size_t k = 0; k < element_->properties.size(); ++k) {
        if (k == indices) {
          (this->*readList)(element_->properties[k]);
        } else {
          skip(element_->properties[k]);
        }
      }
    });
  }

  void readPolygon(const PlyProperty& property) {
    const std::size_t size = nextCount(*property.countType);
    if (size >= 3) {
      if (const std::string limit = limitPassedBy(polygons_, size, limits_); !limit.empty()) fail(limit);
    }
    const std::size_t before = polygons_.corners.size();
    bool good = problem_.empty();
    for (std::size_t i = 0; i < size; ++i) {
      const double index = nextIndex(property.type);
      good = good && index != noIndex;
      if (good) polygons_.corners.push_back(static_cast<std::uint32_t>(index));
    }
    if (good && size >= 3) return polygons_.sizes.push_back(static_cast<std::uint32_t>(size));
    polygons_.corners.resize(before);
    polygons_.sizes.push_back(0);
    ++polygons_.empty;
    remarks_.add(good ? shortFaces : badIndices, [&] {
      return RemarkPlace{where(),
                         good ? fmt::format("expected at least three corners, got {}", size) : problem_};
    });
  }

  // Each corner makes a triangle with the two before it, every other one turned over; -1 begins a new strip.
  void readStrip(const PlyProperty& property) {
    std::size_t left = nextCount(*property.countType);
    if (!problem_.empty()) return remarkBadStrip();
    std::array<double, 2> last{noIndex, noIndex};
    for (std::size_t length = 0; left > 0; --left) {
      const double index = nextIndex(property.type);
      if (index == noIndex && problem_.empty()) {
        length = 0;
        continue;
      }
      if (values_.isText() && values_.lastWord().empty()) return remarkBadStrip();
      if (++length >= 3) addStripTriangle(last[1 - length % 2], last[length % 2], index);
      last = {last[1], index};
      problem_.clear();
    }
  }

  void remarkBadStrip() {
    remarks_.add(brokenStrips, [&] { return RemarkPlace{where(), problem_}; });
  }

  void addStripTriangle(double a, double b, double c) {
    if (a == noIndex || b == noIndex || c == noIndex) {
      return remarks_.add(badStripIndices, [&] {
        return RemarkPlace{where(), fmt::format("expected vertex indices from 0 to {}", vertexCount_ - 1)};
      });
    }
    if (a == b || b == c || c == a) return;  // strips are joined by triangles without area
    if (const std::string limit = limitPassedBy(polygons_, 3, limits_); !limit.empty()) fail(limit);
    for (const double index : {a, b, c}) polygons_.corners.push_back(static_cast<std::uint32_t>(index));
    polygons_.sizes.push_back(3);
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
        fmt::format("a property list vertex_indices of element {}", element_->name));
  }

  template <typename Predicate>
  std::size_t findProperty(const Predicate& isWanted, const std::string& what) const {
    const auto& all = element_->properties;
    const auto found = std::find_if(all.begin(), all.end(), isWanted);
    if (found == all.end()) throw Error(fmt::format("expected {}, got none", what), remarks_.file());
    return static_cast<std::size_t>(found - all.begin());
  }

  // NaN, and a problem_, when the text has no number there. Without a word at the end of the data: cut off.
  double next(PlyType type) {
    const std::optional<double> value = values_.next(type);
    if (value) return *value;
    if (!values_.isText() || (values_.lastWord().empty() && values_.atEnd()))
      fail("expected a number, got the end of the file");
    if (problem_.empty()) problem_ = notANumber();
    return std::numeric_limits<double>::quiet_NaN();
  }

  std::string notANumber() const {
    const std::string_view word = values_.lastWord();
    return fmt::format("expected a number, got {}{}", word.empty() ? "the end of the line" : inQuotes(word),
                       decimalCommaHint(word));
  }

  // The index of a vertex, or noIndex: then with a problem_, unless -1 ends a strip there.
  double nextIndex(PlyType type) {
    const double index = next(type);
    if (index >= 0 && index < static_cast<double>(vertexCount_) && index == std::floor(index)) return index;
    const bool endsStrip = index == -1 && element_->name == "tristrips";
    if (problem_.empty() && !endsStrip)
      problem_ = fmt::format("expected vertex indices from 0 to {}, got {}", vertexCount_ - 1, index);
    return noIndex;
  }

  // 0, and a problem_, when a text has something else there; binary data have no next row to go on with.
  std::size_t nextCount(PlyType type) {
    const double count = next(type);
    constexpr double largest = std::numeric_limits<std::uint32_t>::max();
    if (count >= 0 && count <= largest && count == std::floor(count)) return static_cast<std::size_t>(count);
    const std::string problem = fmt::format("expected the length of a list, got {}", count);
    if (!values_.rowsMayBeShort()) fail(problem_.empty() ? problem : problem_);
    if (problem_.empty()) problem_ = problem;
    return 0;
  }

  // What a row of a text does not have need not be skipped.
  void skip(const PlyProperty& property) {
    if (values_.rowsMayBeShort() && property.countType) {
      const auto count = values_.next(*property.countType);
      if (count && *count >= 0) values_.skip(property.type, static_cast<std::size_t>(std::min(*count, 1e9)));
      return;
    }
    const std::size_t count = property.countType ? nextCount(*property.countType) : 1;
    if (!values_.skip(property.type, count) && !values_.rowsMayBeShort())
      fail("expected more values, got the end of the file");
  }

  std::string where() const { return fmt::format("{} {}", element_->name, row_); }

  std::string whereIs(std::size_t polygon) const {
    const PlyElement* faces = find("face");
    const bool isFace = faces && polygon >= firstFace_ && polygon - firstFace_ < faces->count;
    return isFace ? fmt::format("face {}", polygon - firstFace_) : "tristrips";
  }

  [[noreturn]] void fail(const std::string& message) const { throw Error(message, remarks_.file(), where()); }

  MeshRemarks& remarks_;
  const MeshLimits& limits_;
  PlyHeader header_;
  PlyValues values_;
  std::uint64_t vertexCount_ = 0;
  const PlyElement* element_ = nullptr;  // the one that is being read,
  std::uint64_t row_ = 0;                // its row,
  std::string problem_;                  // and what is wrong with it
  PointArray positions_;
  PolygonSoup polygons_;
  std::size_t firstFace_ = 0;  // among the polygons
};

}  // namespace

Mesh readPly(std::string_view bytes, MeshRemarks& remarks, const MeshLimits& limits) {
  return PlyReader(bytes, remarks, limits).read();
}

}  // namespace anamorph
