// What is under a pixel of the 3D view: an icon, a cell of the pixel grid, the RT camera's body, the sculpture, the
// original or the mirror.
//
// Icons are drawn over everything and are picked first, by their distance on the screen. Of the surfaces the
// nearest one counts, except that a ghost original is seen through the mirror and so is picked through it.
//
// A picked vertex is kept as a place on the original's mesh, not as an index of the sculpture: it stays the
// same vertex while things are dragged and when the sculpture is refined anew.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "edit/display_settings.h"
#include "edit/selection.h"
#include "edit/view_pose.h"
#include "pipeline/stages.h"

namespace anamorph {

struct GridCell {
  int column = 0;
  int row = 0;  ///< 0 on top

  bool operator==(const GridCell&) const = default;
};

/// A place on the original: point = (1 - u - v) a + u b + v c of one of its triangles.
struct PickedPoint {
  std::uint32_t triangle = 0;
  double u = 0, v = 0;

  bool operator==(const PickedPoint&) const = default;
};

struct Pick {
  Selection selection;               ///< none: the background
  std::optional<GridCell> cell;      ///< of the RT camera's pixel grid
  std::optional<PickedPoint> point;  ///< on sculpture and original: the hit triangle's nearest corner
  double distance =
      std::numeric_limits<double>::infinity();  ///< along the ray through the pixel, scene units
  Point where{0};                               ///< what was hit, undefined for the background

  bool operator==(const Pick&) const = default;
};

struct PickInput {
  const ViewProjection& projection;
  const Level& level;
  const PreparedMesh& original;        ///< placed; pointers may be null
  const PreparedSculpture& sculpture;  ///< as it is drawn; pointers may be null
  const DisplaySettings& display;
  Selection selection;  ///< the aim is shown while the RT camera is selected
  double uiScale = 1;
};

constexpr double iconPixels = 12;   ///< how near the mouse has to be, at 100 % UI scale
constexpr double vertexPixels = 6;  ///< likewise, of a vertex that it just misses

Pick pick(const PickInput& input, const Pixel& pixel);

/// The cell of the drawn pixel grid that a ray meets, and where along it (in lengths of its direction).
struct GridHit {
  GridCell cell;
  double t = 0;
};
std::optional<GridHit> intersectGrid(const Camera& camera, const PixelGrid& grid, const Ray& ray);

/// Whether the mesh still has the triangle; another original may not.
bool isOn(const Mesh& original, const PickedPoint& picked);

/// The place in the scene. isOn() is required.
Point pointOn(const Mesh& placedOriginal, const PickedPoint& picked);

/// A vertex of the original, by any triangle that uses it; nothing when none does.
std::optional<PickedPoint> pickedVertex(const Mesh& original, std::uint32_t vertex);

}  // namespace anamorph
