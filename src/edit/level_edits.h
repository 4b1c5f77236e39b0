// What can be done to the selected thing with a gizmo: move, rotate, scale, each a pure function from a level
// to the next one. The same functions serve drags, arrow keys and numbers.
//
//            move   rotate                 scale
//   eye      x      the aim around it      -
//   aim      x      -                      -
//   original x      x                      along its own axes
//   mirror   x      x (not a round one)    along its own axes; a round one uniformly
//   light    x      -                      -
//   sculpture -     -                      its depth scale, uniformly, unless it is frozen
//
// Coordinates and sizes stay within those a level file can have, so that whatever was dragged can be saved:
// scaled to nothing is scaled to 1e-6, which the app then explains. What is not allowed, or not finite,
// changes nothing.
#pragma once

#include <array>
#include <optional>

#include <glm/mat3x3.hpp>

#include "edit/selection.h"
#include "level/level.h"
#include "math/box.h"

namespace anamorph {

enum class GizmoMode { move, rotate, scale };

/// Where a gizmo stands and how it is turned; axes are perpendicular and right-handed.
struct GizmoFrame {
  Point origin{0};
  Axes axes = sceneAxes;

  bool operator==(const GizmoFrame&) const = default;
  bool global() const { return axes == sceneAxes; }
};

/// Whether the selection is a thing of this level that can be changed this way.
bool allows(const Level& level, const Selection& selection, GizmoMode mode);

/// Whether it can only be scaled by the same factor along all axes.
bool scalesUniformly(const Level& level, const Selection& selection);

/// Where the selection's gizmo stands: along the scene's axes, or along its own (`local`; always for the mode
/// scale). Boxes are those of the placed original and of the sculpture, empty when there are none. Nothing
/// when the mode is not allowed or there is no sculpture to scale.
std::optional<GizmoFrame> frameOf(const Level& level, const Selection& selection, GizmoMode mode, bool local,
                                  const Box& originalBox, const Box& sculptureBox);

/// The selection's box, for framing it: a unit cube for points; empty when nothing is selected.
Box boxOf(const Level& level, const Selection& selection, const Box& originalBox, const Box& sculptureBox);

/// Every point of the selected thing moved by `vector`, or less where coordinates end.
Level moved(const Level& level, const Selection& selection, const Vector& vector);

/// Turned about an axis (unit) through a point, counter-clockwise seen from the axis' tip.
Level rotated(const Level& level, const Selection& selection, const Point& origin, const Direction& axis,
              double angleRadians);

/// Scaled along its own axes, with `origin` staying where it is. Negative factors count as 0. Where one
/// factor is needed for several axes, the one that differs most from 1 is taken.
Level scaled(const Level& level, const Selection& selection, const Point& origin, const Vector& factors);

/// Within the coordinates that a level file can have.
Point clampedPoint(const Point& point);

}  // namespace anamorph
