#include "geometry/mesh_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <optional>
#include <system_error>

#include "base/error.h"
#include "base/file.h"
#include "geometry/foreign_formats.h"
#include "geometry/mesh_formats.h"
#include "geometry/mesh_remarks.h"
#include "geometry/normals.h"
#include "geometry/obj_reader.h"
#include "geometry/obj_writer.h"
#include "geometry/ply_reader.h"
#include "geometry/ply_writer.h"
#include "geometry/stl_reader.h"
#include "geometry/stl_writer.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view knownEndings = "expected a file name that ends in .obj, .stl or .ply";

// As much of a regular file as tells its format; nothing of another.
std::string readHead(const fs::path& path) {
  std::error_code failure;
  if (!fs::is_regular_file(path, failure)) return {};
  std::string head(64 * 1024, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  return head;
}

std::optional<MeshFormat> formatOfHead(const fs::path& path, std::string_view head) {
  std::error_code failure;
  const std::uintmax_t size = fs::file_size(path, failure);
  return formatByContent(head, failure ? head.size() : static_cast<std::size_t>(size));
}

// What the file is instead of a mesh, in the words of an Error.
std::string foreignText(const fs::path& path, std::string_view head) {
  const auto ending = formatByEnding(path);
  const ForeignFormat* format = ending ? nullptr : foreignByEnding(path);
  if (!format) format = foreignByContent(head);
  if (!format) return {};
  if (ending) return fmt::format("this is {}, not {}; {}", format->what, nameOf(*ending), format->advice);
  return fmt::format("{} is not read; {}", format->name, format->advice);
}

// Before a large file is read for nothing.
void checkIsMesh(const fs::path& path) {
  if (formatByEnding(path)) return;
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  const bool isPipe = fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
  if (isPipe || isModelFile(path)) {
    if (const std::string foreign = foreignFormatOf(path); !foreign.empty())
      throw Error(foreign, path.string());
    return;
  }
  throw Error(std::string(knownEndings), path.string());
}

// By the content where that is beyond doubt, else by the ending.
MeshFormat formatOf(std::string_view bytes, MeshRemarks& remarks) {
  const auto ending = formatByEnding(remarks.file());
  const auto content = formatByContent(bytes, bytes.size());
  if (!content) {
    if (const std::string foreign = foreignText(remarks.file(), bytes); !foreign.empty())
      throw Error(foreign, remarks.file());
    if (!ending) throw Error(std::string(knownEndings), remarks.file());
  } else if (ending && *ending != *content) {
    remarks.say({}, fmt::format("this is {}, not {}; read as what it is", nameOf(*content), nameOf(*ending)));
  }
  return content ? *content : *ending;
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

std::vector<std::string> writeMesh(const std::filesystem::path& path, const Mesh& mesh, std::string comment) {
  // A comment may hold a file's name, and a file's name may hold a line break.
  std::replace_if(
      comment.begin(), comment.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  const auto format = formatByEnding(path);
  if (!format) throw Error(std::string(knownEndings), path.string());
  AtomicFile file(path);
  if (format == MeshFormat::obj) writeObj(file, mesh, comment);
  if (format == MeshFormat::stl) writeStl(file, mesh, comment, path.string());
  if (format == MeshFormat::ply) writePly(file, mesh, comment);
  return file.commit();
}

}  // namespace

bool isMeshFile(const fs::path& path) {
  return formatByEnding(path).has_value();
}

bool isModelFile(const fs::path& path) {
  if (formatByEnding(path) || foreignByEnding(path)) return true;
  const std::string head = readHead(path);
  return formatOfHead(path, head) || foreignByContent(head);
}

std::string foreignFormatOf(const fs::path& path) {
  if (formatByEnding(path)) return {};
  const std::string head = readHead(path);
  return formatOfHead(path, head) ? std::string() : foreignText(path, head);
}

LoadedMesh readMesh(std::string_view bytes, const std::string& name, const MeshLimits& limits) {
  MeshRemarks remarks(name);
  if (bytes.empty()) throw Error("expected a mesh, got an empty file", name);
  const MeshFormat format = formatOf(bytes, remarks);
  LoadedMesh loaded;
  loaded.mesh = format == MeshFormat::obj   ? readObj(bytes, remarks, limits)
                : format == MeshFormat::stl ? readStl(bytes, remarks, limits)
                                            : readPly(bytes, remarks, limits);
  loaded.warnings = remarks.warnings();
  loaded.up = guessUp(loaded.mesh, format, bytes);
  return loaded;
}

LoadedSurface loadSurface(const fs::path& path, const MeshLimits& limits, const CancelToken* token) {
  checkIsMesh(path);
  const FileBytes bytes = readFile(path, limits.maxBytes, MeshLimits::bytesHelp, token);
  MeshRemarks remarks(path.string());
  if (bytes.view().empty()) throw Error("expected a mesh, got an empty file", path.string());
  if (formatOf(bytes.view(), remarks) != MeshFormat::obj) {
    LoadedMesh loaded = readMesh(bytes.view(), path.string(), limits);
    return {withSmoothNormals(std::move(loaded.mesh)), std::move(loaded.warnings)};
  }
  SmoothMesh surface = readSmoothObj(bytes.view(), remarks, limits);
  return {std::move(surface), remarks.warnings()};
}

LoadedMesh loadMesh(const fs::path& path, const MeshLimits& limits, const CancelToken* token) {
  checkIsMesh(path);
  const FileBytes bytes = readFile(path, limits.maxBytes, MeshLimits::bytesHelp, token);
  return readMesh(bytes.view(), path.string(), limits);
}

std::vector<std::string> saveMesh(const std::filesystem::path& path, const Mesh& mesh,
                                  const MeshFileOptions& options) {
  if (options.scale == 1) return writeMesh(path, mesh, options.comment);
  return writeMesh(path, scaled(mesh, options.scale, path.string()), options.comment);
}

}  // namespace anamorph
