#include "geometry/stl_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "base/error.h"
#include "geometry/file_text.h"
#include "geometry/polygon.h"

namespace anamorph {
namespace {

constexpr Remark badFacets{"1 facet that is not understood left out",
                           "{} facets that are not understood left out"};
constexpr Remark badNumbers{"1 facet with a corner that is not three numbers left out",
                            "{} facets with a corner that is not three numbers left out"};
constexpr Remark shortFacets{"1 facet of fewer than three corners left out",
                             "{} facets of fewer than three corners left out"};
constexpr Remark unknownLines{"1 line that is not understood skipped",
                              "{} lines that are not understood skipped"};
constexpr Remark noEnd{"no endsolid at the end: the file may be cut off", "{} solids without endsolid"};

// Why a facet is left out.
struct BadFacet {
  const Remark& kind;
  std::string problem;
  std::string_view word;  // where
};

class StlText {
 public:
  StlText(std::string_view bytes, MeshRemarks& remarks, const MeshLimits& limits)
      : bytes_(bytes), rest_(withoutPadding(bytes)), remarks_(remarks), limits_(limits) {}

  Mesh read() {
    while (readNext()) {
    }
    return std::move(mesh_);
  }

 private:
  // What stands between facets.
  bool readNext() {
    const std::string_view word = nextWord();
    if (word.empty()) {
      if (inSolid_) remark(noEnd, expected("\"facet\" or \"endsolid\"", word), word);
      return false;
    }
    if (isKeyword(word, "facet")) {
      readFacet();
    } else if (isKeyword(word, "solid")) {
      inSolid_ = true;
      skipLine();
    } else if (isEnd(word, "solid")) {
      inSolid_ = false;
      skipLine();
    } else {
      remark(unknownLines, expected(inSolid_ ? "\"facet\" or \"endsolid\"" : "\"solid\"", word), word);
      skipLine();
    }
    return true;
  }

  void readFacet() {
    const std::size_t before = mesh_.positions.size();
    try {
      readLoop();
    } catch (const BadFacet& bad) {
      remark(bad.kind, bad.problem, bad.word);
      mesh_.positions.resize(before);
      return skipToEnd(bad.word);
    }
    addPolygon(before);
  }

  // "endloop" or "end loop".
  bool isEnd(std::string_view word, std::string_view ofWhat) {
    if (word.size() == 3 + ofWhat.size())
      return isKeyword(word.substr(0, 3), "end") && isKeyword(word.substr(3), ofWhat);
    if (!isKeyword(word, "end")) return false;
    const std::string_view before = rest_;
    if (isKeyword(nextWord(), ofWhat)) return true;
    rest_ = before;
    return false;
  }

  void readLoop() {
    std::string_view word = nextWord();
    if (isKeyword(word, "normal")) {  // some programs write nan here, or nothing
      word = nextWord();
      for (int i = 0; i < 3 && !isKeyword(word, "outer"); ++i) word = nextWord();
    }
    require(isKeyword(word, "outer"), "outer", word);
    word = nextWord();
    require(isKeyword(word, "loop"), "loop", word);
    word = nextWord();
    for (; isKeyword(word, "vertex"); word = nextWord()) readPoint();
    require(isEnd(word, "loop"), "endloop", word);
    word = nextWord();
    require(isEnd(word, "facet"), "endfacet", word);
  }

  void readPoint() {
    Point p;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = nextWord();
      const auto coordinate = parseCoordinate(word);
      if (!coordinate) throw badNumber(word);
      p[axis] = *coordinate;
    }
    mesh_.positions.push_back(p);
  }

  BadFacet badNumber(std::string_view word) const {
    failAtEnd(threeCoordinates, word);
    return {badNumbers, expected(threeCoordinates, word) + decimalCommaHint(word), word};
  }

  void require(bool isThere, std::string_view keyword, std::string_view word) const {
    if (isThere) return;
    failAtEnd(inQuotes(keyword), word);
    throw BadFacet{badFacets, expected(inQuotes(keyword), word), word};
  }

  // On with the next facet, wherever the bad word stood in this one.
  void skipToEnd(std::string_view word) {
    while (!isEnd(word, "facet")) {
      failAtEnd("\"endfacet\"", word);
      if (isKeyword(word, "facet") || isKeyword(word, "solid") || isKeyword(word, "endsolid")) {
        rest_ = {word.data(), static_cast<std::size_t>(rest_.data() + rest_.size() - word.data())};
        return;
      }
      word = nextWord();
    }
  }

  // The corners from `first` on, a triangle nearly always.
  void addPolygon(std::size_t first) {
    const std::size_t count = mesh_.positions.size() - first;
    if (count < 3) {
      remark(shortFacets, fmt::format("expected at least three corners, got {}", count), lastWord_);
      return mesh_.positions.resize(first);
    }
    if (count > maxPolygonCorners)
      fail(fmt::format("expected at most {} corners, got {}", maxPolygonCorners, count));
    if (mesh_.triangles.size() + count - 2 > limits_.maxTriangles())
      throw Error(limits_.tooManyTriangles(), remarks_.file());
    const auto index = static_cast<std::uint32_t>(first);
    if (count == 3) {
      mesh_.triangles.push_back({index, index + 1, index + 2});
    } else {
      triangulatePolygon(mesh_.positions, differentCorners(index), mesh_.triangles);
    }
  }

  // Some repeat the first corner as the last.
  std::vector<std::uint32_t> differentCorners(std::uint32_t first) const {
    std::vector<std::uint32_t> corners(mesh_.positions.size() - first);
    std::iota(corners.begin(), corners.end(), first);
    const auto areSame = [&](std::uint32_t a, std::uint32_t b) {
      return mesh_.positions[a] == mesh_.positions[b];
    };
    corners.erase(std::unique(corners.begin(), corners.end(), areSame), corners.end());
    while (corners.size() > 1 && areSame(corners.front(), corners.back())) corners.pop_back();
    return corners;
  }

  // Comments are no part of STL, but of some files.
  std::string_view nextWord() { return lastWord_ = takeWordPastComments(rest_); }

  void skipLine() { rest_.remove_prefix(std::min(rest_.find_first_of("\r\n"), rest_.size())); }

  void remark(const Remark& kind, const std::string& problem, std::string_view word) {
    remarks_.add(kind, [&] { return RemarkPlace{where(word), problem}; });
  }

  static std::string expected(std::string_view what, std::string_view got) {
    return fmt::format("expected {}, got {}", what, inQuotesOrEnd(got));
  }

  std::string where(std::string_view word) const {
    return lineAt(bytes_, static_cast<std::size_t>(word.data() - bytes_.data()));
  }

  // In a facet the end of the file means that it is cut off.
  void failAtEnd(std::string_view what, std::string_view word) const {
    if (word.empty()) fail(expected(what, word));
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw Error(message, remarks_.file(), where(lastWord_));
  }

  std::string_view bytes_, rest_, lastWord_;
  MeshRemarks& remarks_;
  const MeshLimits& limits_;
  Mesh mesh_;
  bool inSolid_ = false;
};

}  // namespace

Mesh readTextStl(std::string_view bytes, MeshRemarks& remarks, const MeshLimits& limits) {
  return StlText(bytes, remarks, limits).read();
}

}  // namespace anamorph
