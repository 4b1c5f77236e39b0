#include "geometry/mesh_formats.h"

#include <algorithm>
#include <array>

#include "base/folder.h"
#include "geometry/file_text.h"
#include "geometry/stl_binary.h"

namespace anamorph {
namespace {

bool hasKeyword(std::string_view text, std::string_view keyword) {
  for (std::string_view word; !(word = takeWord(text)).empty();) {
    if (isKeyword(word, keyword)) return true;
  }
  return false;
}

// Whether the first line that says anything is one of an OBJ, and a vertex follows.
bool isObj(std::string_view head) {
  constexpr std::array<std::string_view, 14> keywords{"v", "vn", "vt",     "vp",     "f",      "fo",     "o",
                                                      "g", "s",  "mtllib", "usemtl", "cstype", "usemap", "l"};
  bool isBegun = false;
  LineReader lines(head);
  for (std::string_view line; lines.next(line);) {
    const std::string_view keyword = takeWord(line);
    if (keyword.empty() || keyword[0] == '#') continue;
    if (std::find(keywords.begin(), keywords.end(), keyword) == keywords.end() && !isBegun) return false;
    isBegun = true;
    if (keyword == "v" && parseNumber(takeWord(line)) && parseNumber(takeWord(line))) return true;
  }
  return false;
}

}  // namespace

std::string_view nameOf(MeshFormat format) {
  return format == MeshFormat::obj ? "an OBJ" : format == MeshFormat::stl ? "an STL" : "a PLY";
}

std::optional<MeshFormat> formatByEnding(const std::filesystem::path& path) {
  const std::string ending = lowerEnding(path);
  if (ending == ".obj") return MeshFormat::obj;
  if (ending == ".stl") return MeshFormat::stl;
  if (ending == ".ply") return MeshFormat::ply;
  return std::nullopt;
}

std::optional<MeshFormat> formatByContent(std::string_view head, std::size_t fileSize) {
  if (isExactBinaryStl(head, fileSize)) return MeshFormat::stl;
  std::string_view rest = withoutByteOrderMark(head.substr(0, 64 * 1024));
  const std::string_view text = rest;
  const std::string_view word = takeWordPastComments(rest);
  if (word == "ply" && hasKeyword(rest, "format")) return MeshFormat::ply;
  if (isKeyword(word, "solid") && hasKeyword(rest, "facet")) return MeshFormat::stl;
  if (isObj(text)) return MeshFormat::obj;
  return std::nullopt;
}

}  // namespace anamorph
