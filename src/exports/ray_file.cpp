#include "exports/ray_file.h"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "anamorphosis/vertex_ray.h"
#include "raytrace/ray_looks.h"

namespace anamorph {
namespace {

// Numbers of points go on through the file, beginning with 1.
class ObjLines {
 public:
  explicit ObjLines(double scale) : scale_(scale) {}

  std::size_t add(const Point& p) {
    const Point q = scale_ * p;
    fmt::format_to(std::back_inserter(text_), FMT_COMPILE("v {} {} {}\n"), q.x, q.y, q.z);
    return ++points_;
  }
  template <typename... Arguments>
  void write(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
  }
  std::string text() const { return fmt::to_string(text_); }

 private:
  double scale_;
  std::size_t points_ = 0;
  fmt::memory_buffer text_;
};

}  // namespace

std::optional<std::string> makeVertexRayObj(const LevelResult& finished, int count, double millimetresPerUnit,
                                            const Progress& progress) {
  const VertexMap map = makeVertexMap(finished.level);
  const PointArray& vertices = finished.source->positions;
  const std::size_t wanted = std::min<std::size_t>(std::max(count, 0), vertices.size());
  ObjLines file(millimetresPerUnit);
  file.write("# vertex rays: from the eye to the mirror to the sculpture, made by Anamorph\no vertex_rays\n");
  const std::size_t eye = file.add(map.eye);
  std::size_t notMapped = 0;
  for (std::size_t i = 0; i < wanted; ++i) {
    if (i % 4096 == 0 && !progress.update(double(i) / double(wanted))) return std::nullopt;
    // At the middle of each of `wanted` equal parts of the list, as in the 3D view.
    const std::size_t vertex = (2 * i + 1) * vertices.size() / (2 * wanted);
    const VertexRay ray = makeVertexRay(map, vertices[vertex]);
    if (!ray.mapped()) {
      ++notMapped;
      continue;
    }
    std::string line = fmt::format("l {}", eye);
    for (const VertexLeg& leg : ray.legs) line += fmt::format(" {}", file.add(leg.start));
    file.write("{} {}\n", line, file.add(ray.sculpture));
  }
  file.write("# {} rays, {} not mapped and left out\n", wanted - notMapped, notMapped);
  return file.text();
}

std::optional<std::string> makePixelRayObj(const LevelResult& finished, double millimetresPerUnit,
                                           const Progress& progress) {
  const Level& level = finished.level;
  const Camera& camera = level.camera;
  const PixelGrid& grid = level.grid;
  const RenderScene scene = buildScene(makeReflectionScene(level, finished.sculpture));
  const ImageRequest request = makeImageRequest(level, grid.columns, grid.rows, 1);
  std::array<std::vector<RaySegment>, rayLooks.size()> byKind;
  for (int y = 0; y < grid.rows; ++y) {
    if (!progress.update(double(y) / grid.rows)) return std::nullopt;
    for (int x = 0; x < grid.columns; ++x) {
      for (const RaySegment& ray : tracePath(scene, camera, request, {x + 0.5, y + 0.5}).segments)
        byKind[static_cast<std::size_t>(ray.kind)].push_back(ray);
    }
  }
  ObjLines file(millimetresPerUnit);
  file.write("# rays of the {} x {} pixel grid, made by Anamorph\n", grid.columns, grid.rows);
  for (std::size_t kind = 0; kind < byKind.size(); ++kind) {
    if (byKind[kind].empty()) continue;
    file.write("o {}\n", rayLooks[kind].fileName);
    for (const RaySegment& ray : byKind[kind]) {
      const std::size_t from = file.add(ray.from), to = file.add(ray.to);
      file.write("l {} {}\n", from, to);
    }
  }
  return file.text();
}

}  // namespace anamorph
