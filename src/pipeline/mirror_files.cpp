#include "pipeline/mirror_files.h"

#include <iterator>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "geometry/mesh_files.h"
#include "level/surface_files.h"

namespace anamorph {
namespace {

constexpr double mostKinkDegrees =
    10;  // beyond it the triangles show in what is reflected (method-optics, section 3)

}  // namespace

std::vector<std::string> readMirrorFiles(LevelScene& level, const std::filesystem::path& levelPath,
                                         const MeshLimits& limits, const CancelToken* token) {
  std::vector<std::string> warnings;
  std::map<std::string, SurfaceFile> read;  // a frozen sculpture has most often the same
  changeSurfaceFiles(level, [&](SurfaceFile& file) {
    if (file.path.empty() || file.mesh || !file.problem.empty()) return;
    const auto [known, isNew] = read.try_emplace(file.path, file);
    SurfaceFile& result = known->second;
    if (isNew) {
      const std::string path = surfacePath(file, levelPath).string();
      try {
        LoadedSurface loaded = loadSurface(path, limits, token);
        const double kink = largestKinkDegrees(loaded.surface);
        result.mesh = std::make_shared<const SmoothMesh>(std::move(loaded.surface));
        std::move(loaded.warnings.begin(), loaded.warnings.end(), std::back_inserter(warnings));
        if (kink > mostKinkDegrees) {
          warnings.push_back(fmt::format(
              "{}: some triangles lean by {:.0f} degrees from the normals at their corners, so that what is "
              "reflected has kinks; finer triangles, of 10 degrees at most, have none that are seen",
              path, kink));
        }
      } catch (const Error& error) {
        result.problem = error.what();
      }
    }
    file = result;
  });
  boxOf(level.optic);  // its tree is made here, where nobody waits for a frame
  return warnings;
}

std::vector<std::string> readMirrorFiles(LevelScene& level, const LevelScene& known,
                                         const std::filesystem::path& levelPath) {
  LevelScene source = known;
  std::map<std::string, SurfaceFile> read;
  changeSurfaceFiles(source, [&](const SurfaceFile& file) { read.emplace(file.path, file); });
  changeSurfaceFiles(level, [&](SurfaceFile& file) {
    const auto same = read.find(file.path);
    if (!file.mesh && same != read.end()) file = same->second;
  });
  return readMirrorFiles(level, levelPath);
}

}  // namespace anamorph
