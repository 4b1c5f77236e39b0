// What the 3D view shows: a value, made anew every frame and compared.
#pragma once

#include <memory>
#include <vector>

#include "edit/display_settings.h"
#include "edit/selection.h"
#include "edit/view_pose.h"
#include "level/level.h"
#include "pipeline/stages.h"
#include "raytrace/image.h"
#include "viewport/line.h"

namespace anamorph {

struct ViewportInput {
  int width = 1, height = 1;  ///< pixels, of the picture at full scale
  ViewPose pose;
  LevelScene level;             ///< optic, looks, materials, lights, ground, camera
  PreparedMesh original;        ///< all pointers null: not there
  PreparedSculpture sculpture;  ///< the same; corners whose status is not `mapped` take their triangles out
  DisplaySettings display;
  Selection selection;                             ///< is outlined in orange
  std::shared_ptr<const std::vector<Line>> lines;  ///< may be null
  /// Linear light, shown on the RT camera's pixel grid; null: an empty grid.
  std::shared_ptr<const Image> screen;
  double lineScale = 1;      ///< UI scale
  bool transparent = false;  ///< no background, no ground: alpha 0 where nothing is

  bool operator==(const ViewportInput&) const = default;
};

}  // namespace anamorph
