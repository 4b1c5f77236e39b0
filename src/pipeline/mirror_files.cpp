#include "pipeline/mirror_files.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "geometry/bvh.h"
#include "geometry/mesh_files.h"
#include "level/surface_files.h"

namespace anamorph {
namespace {

constexpr double mostKinkDegrees =
    10;  // beyond it the triangles show in what is reflected (method-optics, section 3)

// With its tree: that is made here, where no frame waits for it.
SurfaceFile readSurface(SurfaceFile file, const std::string& path, const MeshLimits& limits,
                        const CancelToken* token, std::vector<std::string>& warnings) {
  try {
    LoadedSurface loaded = loadSurface(path, limits, token);
    const Mesh& mesh = loaded.surface.mesh;
    const bool hasArea = std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
      return areaVector(mesh.positions, t) != Vector(0);
    });
    if (!hasArea && !mesh.triangles.empty())
      throw Error("expected a mesh with an area, got one whose triangles are all lines or points", path);
    if (mesh.triangles.size() <= SurfaceFile::mostTriangles)
      file.tree = std::make_shared<const Bvh>(mesh.positions, mesh.triangles, 0);
    std::move(loaded.warnings.begin(), loaded.warnings.end(), std::back_inserter(warnings));
    const double kink = largestKinkDegrees(loaded.surface);
    if (kink > mostKinkDegrees) {
      warnings.push_back(
          fmt::format("{}: some triangles lean by {:.0f} degrees from the normals at their corners, so that "
                      "what is reflected "
                      "has kinks; of finer triangles, {} degrees at most, none are seen",
                      path, kink, mostKinkDegrees));
    }
    file.mesh = std::make_shared<const SmoothMesh>(std::move(loaded.surface));
  } catch (const Error& error) {
    file.problem = error.what();
  }
  return file;
}

}  // namespace

std::vector<std::string> readMirrorFiles(LevelScene& level, const std::filesystem::path& levelPath,
                                         const MeshLimits& limits, const CancelToken* token) {
  std::vector<std::string> warnings;
  std::map<std::string, SurfaceFile> read;  // a frozen sculpture has most often the same
  changeSurfaceFiles(level, [&](SurfaceFile& file) {
    if (file.path.empty() || file.mesh || !file.problem.empty()) return;
    const auto [known, isNew] = read.try_emplace(file.path);
    if (isNew)
      known->second = readSurface(file, surfacePath(file, levelPath).string(), limits, token, warnings);
    file = known->second;
  });
  return warnings;
}

bool takeMirrorFiles(LevelScene& level, const LevelScene& known) {
  LevelScene source = known;
  std::map<std::string, SurfaceFile> read;
  changeSurfaceFiles(source, [&](const SurfaceFile& file) { read.emplace(file.path, file); });
  bool others = false;
  changeSurfaceFiles(level, [&](SurfaceFile& file) {
    const auto same = read.find(file.path);
    if (!file.mesh && same != read.end()) file = same->second;
    others |= !file.path.empty() && !file.mesh && file.problem.empty();
  });
  return others;
}

}  // namespace anamorph
