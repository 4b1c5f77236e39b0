#include "geometry/obj_reader.h"

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <istream>
#include <streambuf>
#include <utility>

#include "base/error.h"
#include "geometry/file_text.h"
#include "geometry/polygon.h"

namespace anamorph {
namespace {

bool startsWithKeyword(std::string_view line, char keyword) {
  return !line.empty() && line[0] == keyword && (line.size() == 1 || isBlank(line[1]));
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

// The text as tinyobj gets it. tinyobj knows the syntax of faces; its numbers, though, are off by some units
// in the last place, and it makes 0 of what is no number. So the `v` lines are read here on the way and only
// the `f` lines handed on, one at a time: when tinyobj reports a face, the vertices above it have been read,
// which is what negative indices count from.
class ObjText : public std::streambuf {
 public:
  ObjText(std::string_view bytes, const std::string& file, const MeshLimits& limits)
      : lines_(bytes), file_(file), limits_(limits) {}

  void addFace(const tinyobj::index_t* corners, int count) {
    const auto size = static_cast<std::size_t>(count);
    if (const std::string problem = problemWithPolygon(polygons, size, limits_); !problem.empty())
      fail(problem);
    for (std::size_t i = 0; i < size; ++i) polygons.corners.push_back(resolve(corners[i].vertex_index));
    polygons.sizes.push_back(static_cast<std::uint32_t>(size));
  }

  PointArray positions;
  PolygonSoup polygons;

 protected:
  int_type underflow() override {
    for (std::string_view line; lines_.next(line);) {
      while (!line.empty() && isBlank(line[0])) line.remove_prefix(1);
      if (startsWithKeyword(line, 'v')) {
        addVertex(line.substr(1));
      } else if (startsWithKeyword(line, 'f')) {
        return handOn(line);
      }
    }
    return traits_type::eof();
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw Error(message, file_, fmt::format("line {}", lines_.number()));
  }

  // What follows the three coordinates (a weight, a colour) is skipped.
  void addVertex(std::string_view text) {
    std::string_view rest = text;
    const auto x = parseCoordinate(takeWord(rest));
    const auto y = parseCoordinate(takeWord(rest));
    const auto z = parseCoordinate(takeWord(rest));
    if (!x || !y || !z) fail(fmt::format("expected {}, got {}", threeCoordinates, inQuotes(trimmed(text))));
    if (positions.size() == limits_.maxVertices) {
      fail(fmt::format("expected at most {} vertices; --max-vertices raises the limit", limits_.maxVertices));
    }
    positions.push_back({*x, *y, *z});
  }

  int_type handOn(std::string_view line) {
    line = line.substr(0, line.find('#'));
    if (!isFaceText(line.substr(1))) {
      fail(fmt::format("expected vertex indices such as 3 or 3/1/2, got {}",
                       inQuotes(trimmed(line.substr(1)))));
    }
    if (line.find_first_of("0123456789/-") == std::string_view::npos)
      fail("expected at least three corners, got 0");
    line_.assign(line).push_back('\n');
    setg(line_.data(), line_.data(), line_.data() + line_.size());
    return traits_type::to_int_type(line_[0]);
  }

  // From the file's index (1 is the first vertex, -1 the last one so far) to ours. Whether a vertex with a
  // larger index follows is known only at the end.
  std::uint32_t resolve(int index) const {
    const auto count = static_cast<std::int64_t>(positions.size());
    if (index == 0) fail("expected vertex indices from 1 on, or negative ones, got 0");
    if (-index > count)
      fail(fmt::format("expected a vertex above this line, got {} after {} vertices", index, count));
    return static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
  }

  LineReader lines_;
  const std::string& file_;
  const MeshLimits& limits_;
  std::string line_;
};

// The line of the n-th face, found only when a message needs it.
std::string lineOfFace(std::string_view bytes, std::size_t n) {
  LineReader lines(bytes);
  for (std::string_view line; lines.next(line);) {
    if (startsWithKeyword(trimmed(line), 'f') && n-- == 0) break;
  }
  return fmt::format("line {}", lines.number());
}

void checkIndices(const ObjText& text, std::string_view bytes, const std::string& file) {
  const auto& corners = text.polygons.corners;
  const std::size_t count = text.positions.size();
  const auto bad = std::find_if(corners.begin(), corners.end(), [&](std::uint32_t i) { return i >= count; });
  if (bad == corners.end()) return;
  std::size_t face = 0;
  for (std::ptrdiff_t end = text.polygons.sizes[0]; bad - corners.begin() >= end;)
    end += text.polygons.sizes[++face];
  throw Error(fmt::format("expected vertex indices up to {}, got {}", count, std::size_t{*bad} + 1), file,
              lineOfFace(bytes, face));
}

}  // namespace

Mesh readObj(std::string_view bytes, const std::string& file, const MeshLimits& limits) {
  ObjText text(bytes, file, limits);
  std::istream stream(&text);
  stream.exceptions(std::ios::badbit);  // without it the stream keeps the Errors of ObjText to itself
  tinyobj::callback_t callbacks;
  callbacks.index_cb = [](void* data, tinyobj::index_t* corners, int count) {
    static_cast<ObjText*>(data)->addFace(corners, count);
  };
  tinyobj::LoadObjWithCallback(stream, callbacks, &text);

  checkIndices(text, bytes, file);
  Mesh mesh;
  mesh.triangles = triangulate(text.positions, text.polygons);
  mesh.positions = std::move(text.positions);
  return mesh;
}

}  // namespace anamorph
