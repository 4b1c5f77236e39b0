// Dragging a handle of the gizmo: from where the mouse is now to what the level is then. The level is always
// made anew from the one at the start, so errors do not add up and the start is found again exactly.
//
//   axis     the point of the axis nearest to the mouse's ray        ----o----x---> axis
//   plane    where the ray meets the plane                                    '.
//   ring     the angle there; whole turns count, too                            '.  ray
//   scale    the fraction of the distance from the origin                            eye
//
// What is remembered is only what a single position cannot tell: how many times a ring has been gone around,
// how much slower some of the way was, and the last good value for where the ray meets nothing (past the
// horizon of a plane).
#pragma once

#include <optional>
#include <string>

#include "edit/gizmo.h"

namespace anamorph {

constexpr double snapLength = 0.25, snapAngleDegrees = 15, snapFactor = 0.1;
constexpr double fineFraction = 0.1;  ///< of the mouse's motion, and of the snapping, while it is fine

struct GizmoDragStart {
  Level level;
  Selection selection;
  GizmoFrame frame;
  GizmoMode mode = GizmoMode::move;
  GizmoHandle handle = GizmoHandle::all;
  ViewProjection projection;
  Pixel pixel{0};
  double uiScale = 1;
};

/// The keys that are held or were typed during the drag.
struct DragKeys {
  bool snap = false;  ///< Ctrl: steps; positions on the grid where the frame has the scene's axes
  bool fine = false;  ///< Shift: slower from here on
  std::optional<int> axisLock = std::nullopt;  ///< X, Y, Z: this axis (0..2) whatever the handle
};

class GizmoDrag {
 public:
  explicit GizmoDrag(GizmoDragStart start);

  /// The level for this position of the mouse. Where it started, exactly the level at the start. Always
  /// finite.
  Level levelAt(const Pixel& pixel, const DragKeys& keys = {});

  /// What the last levelAt did: "x +1.25", "15.0° about z", "scale 0.80", "k = 0.44".
  const std::string& text() const { return text_; }
  const GizmoDragStart& start() const { return start_; }

 private:
  // A motion, a turn (x: radians) or factors less 1 (x), as the mouse alone says; nothing where it says
  // nothing.
  std::optional<Vector> measure(const Pixel& pixel);
  std::optional<Vector> measureMove(const Pixel& pixel) const;
  std::optional<double> measureScale(const Pixel& pixel) const;
  std::optional<double> measureTurn(const Pixel& pixel);

  std::optional<Vector> onPlane(const Pixel& pixel, const Direction& normal) const;
  std::optional<double> onAxis(const Pixel& pixel, const Direction& axis) const;
  std::optional<double> ringAngle(const Pixel& pixel, const Direction& axis) const;
  std::optional<Pixel> edgeOnTangent(const Direction& axis) const;

  void chooseHandle(const DragKeys& keys);
  Direction handleAxis() const;
  bool movesAlong(int axis) const;
  Level applyMove(Vector motion, double snap);
  Level applyTurn(double angle, double snap);
  Level applyScale(double factor, double snap);
  Level applyDepth(double factor, double snap);

  GizmoDragStart start_;
  GizmoHandle handle_;                          // start_.handle or that of the lock
  std::optional<double> ringStart_, ringLast_;  // angles
  double ringTurns_ = 0;
  Vector last_{0};    // the last good measure
  Vector slowed_{0};  // what fine motion has taken off it
  std::string text_;
};

}  // namespace anamorph
