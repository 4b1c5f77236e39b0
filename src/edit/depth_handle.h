// The handle of the depth scale: it sits at S on a vertex ray and is dragged along it. Measured from Q, where S would be
// for k = 0, it is scaled as any other axis is (gizmo_drag.h), so S stays under the mouse.
//
//      Q ------- S  [k]       axis: Q towards S
#pragma once

#include <optional>

#include "anamorphosis/vertex_ray.h"
#include "edit/gizmo.h"

namespace anamorph {

/// Its place, with Q as the origin and the ray as the first axis; nothing for a vertex that is not mapped.
std::optional<GizmoFrame> depthFrame(const VertexRay& ray);

/// The part of the ray that it is dragged along, and the box at S. Empty where they are not in front of the eye.
Gizmo makeDepthHandle(const ViewProjection& projection, const GizmoFrame& frame, const Point& sculpture,
                      double uiScale);

}  // namespace anamorph
