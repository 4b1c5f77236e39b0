#include "geometry/mesh_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/file.h"
#include "base/folder.h"
#include "geometry/obj_reader.h"
#include "geometry/obj_writer.h"
#include "geometry/ply_reader.h"
#include "geometry/ply_writer.h"
#include "geometry/stl_reader.h"
#include "geometry/stl_writer.h"

namespace anamorph {
namespace {

enum class Format { obj, stl, ply };

std::optional<Format> findFormat(const std::filesystem::path& path) {
  const std::string ending = lowerEnding(path);
  if (ending == ".obj") return Format::obj;
  if (ending == ".stl") return Format::stl;
  if (ending == ".ply") return Format::ply;
  return std::nullopt;
}

Format formatOf(const std::filesystem::path& path) {
  if (const auto format = findFormat(path)) return *format;
  throw Error("expected a file name that ends in .obj, .stl or .ply", path.string());
}

Mesh scaled(Mesh mesh, double scale, const std::string& name) {
  for (auto* axis : {&mesh.positions.x, &mesh.positions.y, &mesh.positions.z}) {
    for (double& value : *axis) {
      value *= scale;
      if (!std::isfinite(value))
        throw Error(fmt::format("cannot write: a scale of {} is too large", scale), name);
    }
  }
  return mesh;
}

void writeMesh(const std::filesystem::path& path, const Mesh& mesh, std::string comment) {
  // A comment may hold a file's name, and a file's name may hold a line break.
  std::replace_if(
      comment.begin(), comment.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  const Format format = formatOf(path);
  AtomicFile file(path);
  if (format == Format::obj) writeObj(file, mesh, comment);
  if (format == Format::stl) writeStl(file, mesh, comment, path.string());
  if (format == Format::ply) writePly(file, mesh, comment);
  file.commit();
}

Mesh readAs(Format format, std::string_view bytes, const std::string& name, const MeshLimits& limits) {
  if (bytes.empty()) throw Error("expected a mesh, got an empty file", name);
  Mesh mesh = format == Format::obj   ? readObj(bytes, name, limits)
              : format == Format::stl ? readStl(bytes, name, limits)
                                      : readPly(bytes, name, limits);
  if (mesh.triangles.empty()) {
    throw Error(
        fmt::format("expected at least one triangle, got none and {} vertices", mesh.positions.size()), name);
  }
  return mesh;
}

}  // namespace

bool isMeshFile(const std::filesystem::path& path) {
  return findFormat(path).has_value();
}

Mesh readMesh(std::string_view bytes, const std::string& name, const MeshLimits& limits) {
  return readAs(formatOf(name), bytes, name, limits);
}

Mesh readMeshByContent(std::string_view bytes, const std::string& name, const MeshLimits& limits) {
  return readAs(bytes.starts_with("ply") ? Format::ply
                : looksLikeStl(bytes)    ? Format::stl
                                         : Format::obj,
                bytes, name, limits);
}

Mesh loadMesh(const std::filesystem::path& path, const MeshLimits& limits, const CancelToken* token) {
  formatOf(path);  // before a large file is read for nothing
  const FileBytes bytes = readFile(path, limits.maxBytes, MeshLimits::bytesHelp, token);
  return readMesh(bytes.view(), path.string(), limits);
}

void saveMesh(const std::filesystem::path& path, const Mesh& mesh, const MeshFileOptions& options) {
  if (options.scale == 1) {
    writeMesh(path, mesh, options.comment);
  } else {
    writeMesh(path, scaled(mesh, options.scale, path.string()), options.comment);
  }
}

}  // namespace anamorph
