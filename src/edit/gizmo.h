// The gizmo: handles in the picture at the selected thing, to move, rotate or scale it with the mouse. Here
// is what it looks like, as plain shapes in pixels, and which handle is under the mouse; what dragging one
// does is in gizmo_drag.h.
//
//      z              It has the same size on the screen wherever it stands. A handle that could not be
//      |  [yz]        dragged well is left out: an axis seen end-on, a plane seen edge-on. Of a ring the half
//      |              behind is dim.
//      o------ y
//     /               Move: arrows, planes, a circle for the plane of the picture. Rotate: three rings and one
//    x  [xy]          around them, in the plane of the picture. Scale: boxes, planes, a box in the middle for
//                     all.
#pragma once

#include <vector>

#include "edit/level_edits.h"
#include "edit/view_pose.h"

namespace anamorph {

enum class GizmoHandle {
  none,
  x,
  y,
  z,  ///< along an axis; a ring about it
  yz,
  zx,
  xy,   ///< in a plane
  all,  ///< in the plane of the picture; uniformly
};

/// The axis of x, y, z, or the one perpendicular to yz, zx, xy: 0..2; 3 for the rest.
int axisOf(GizmoHandle handle);

/// Length of its axes in pixels at 100 % UI scale.
constexpr double gizmoPixels = 90;

struct GizmoShape {
  enum class Emphasis { dim, normal, strong };

  GizmoHandle handle = GizmoHandle::none;
  std::vector<Pixel> points;  ///< of a polyline, or of a convex polygon to fill
  bool filled = false;
  int color = 3;  ///< the axis 0..2, or 3
  Emphasis emphasis = Emphasis::normal;
  double depth =
      0;  ///< of its middle behind the origin, in lengths of an axis: negative is nearer to the viewer
};

struct Gizmo {
  std::vector<GizmoShape> shapes;  ///< those in front come last
  double uiScale = 1;

  bool empty() const { return shapes.empty(); }
};

/// Empty where the origin is not in front of the eye. `uniformOnly`: to scale, only the handle for all axes.
Gizmo makeGizmo(const ViewProjection& projection, const GizmoFrame& frame, GizmoMode mode, double uiScale,
                bool uniformOnly = false);

/// Without the handles for what cannot be moved: only the first `freedom` axes are free.
Gizmo restricted(Gizmo gizmo, int freedom);

/// The handle within 7 pixels (at 100 %) of the mouse: the nearest one, parts in front before those behind.
GizmoHandle pickHandle(const Gizmo& gizmo, const Pixel& pixel);

/// The same gizmo with one handle strong, for the one under the mouse.
Gizmo emphasised(Gizmo gizmo, GizmoHandle handle);

/// From the eye to a point, or along the parallel rays.
Direction viewDirection(const ViewProjection& projection, const Point& point);

}  // namespace anamorph
