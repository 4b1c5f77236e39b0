// Navigation of the 3D view: how mouse and keys change from where it is seen. Every function takes a pose and
// returns the next one; nothing is remembered between them.
//
//          pole (z)               The eye turns about the pole and over the right-hand axis of the picture, so
//            |   eye              the horizon stays level. A pose that is not level (one that looks through a
//            |  /                 tilted RT camera) turns about its own `up` instead and so starts without a
//            | / distance         jump; upright() and the sides of viewFrom() bring z up again.
//          target --- right
//
// Whatever is given, also an eye at its target or numbers that are not finite, a sound pose is returned.
#pragma once

#include <functional>

#include "edit/view_pose.h"
#include "math/box.h"

namespace anamorph {

constexpr double orbitDegreesPerPixel = 0.4;
constexpr double orbitMaxPitchDegrees = 89.9;
constexpr double zoomPerStep = 1.15;                             ///< one step of the mouse wheel
constexpr double minViewDistance = 1e-3, maxViewDistance = 1e5;  ///< from the eye to the target, scene units

/// The pose itself, or the nearest one from which something can be seen: finite, the eye not at the target,
/// an up.
ViewPose soundPose(const ViewPose& pose);

/// The axes of the picture seen from a pose, those of its ViewProjection.
Frame frameOf(const ViewPose& pose);

/// Whether z is up in the picture: its lower edge is horizontal, whichever way it looks.
bool isLevel(const ViewPose& pose);

/// The same line of sight with z up.
ViewPose upright(const ViewPose& pose);

/// Turns around the target as if the scene were held at the mouse.
ViewPose orbit(const ViewPose& pose, double dxPixels, double dyPixels);

/// Moves eye and target so that what is at the target's depth follows the mouse.
ViewPose pan(const ViewPose& pose, const ViewProjection& projection, double dxPixels, double dyPixels);

/// A motion of the view that does not go through the floor by accident: an eye above it goes as far as it stays there.
/// `moved`: the pose after a fraction of the motion, 0..1. An eye that is below already is free.
ViewPose keptAbove(double floor, const ViewPose& pose, const std::function<ViewPose(double fraction)>& moved);

/// Comes nearer by `steps` of the wheel (negative: goes away), towards what is under the pixel at the
/// target's depth; that point stays there.
ViewPose zoomTo(const ViewPose& pose, const ViewProjection& projection, const Pixel& pixel, double steps);

/// The same towards any point, for example the one of a surface under the mouse: it stays where it is seen.
ViewPose zoomTowards(const ViewPose& pose, const Point& point, double steps);

/// Turns around this point from now on: it comes to the middle of the picture, direction and distance stay.
ViewPose setCentre(const ViewPose& pose, const Point& point);

/// The same direction, at the distance where the box just fits a picture of this width / height. A box
/// without size comes to the centre; an empty one changes nothing.
ViewPose frameBox(const ViewPose& pose, const Box& box, double aspect);

enum class ViewSide { front, back, left, right, top, bottom };

/// Seen from one of the six sides, z up (y away from the viewer's feet where it looks along z). Target and
/// distance stay. Front is where y is smallest.
ViewPose viewFrom(const ViewPose& pose, ViewSide side);

/// Parallel rays or back; what is at the target keeps its size.
ViewPose togglePerspective(const ViewPose& pose);

}  // namespace anamorph
