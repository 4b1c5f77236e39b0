// From where the 3D view is seen. Free of the level: moving the view never changes what is made.
#pragma once

#include <optional>

#include "math/frame.h"
#include "math/ray.h"
#include "optics/camera.h"

namespace anamorph {

struct ViewPose {
  Point eye{16, -20, 13};
  Point target{0, 0, 2};      ///< what it turns around, in the middle of the picture
  Direction up{0, 0, 1};      ///< need not be perpendicular to the line of sight
  double fovDegrees = 40;     ///< vertical
  bool orthographic = false;  ///< parallel rays; the picture is as large as at the target in perspective

  bool operator==(const ViewPose&) const = default;
};

/// A pose with a picture size: turns pixels into rays and points into pixels, as optics/camera.h does for the RT
/// camera (the same numbers for the same pose).
class ViewProjection {
 public:
  /// Width and height in pixels, both > 0.
  ViewProjection(const ViewPose& pose, int width, int height);

  /// Through an image position; its direction has length 1. Orthographic rays start beside the eye.
  Ray rayThrough(const Pixel& pixel) const;

  /// Where a point is seen; nothing when it is not in front of the eye (perspective).
  std::optional<Pixel> pixelOf(const Point& point) const;

  /// The size of a pixel at a point's depth, scene units.
  double unitsPerPixel(const Point& point) const;

  const Point& eye() const { return eye_; }
  const Frame& frame() const { return frame_; }
  int width() const { return width_; }
  int height() const { return height_; }
  bool orthographic() const { return orthographic_; }
  /// Perspective: half the height of the picture at distance 1. Orthographic: half its height, scene units.
  double halfHeight() const { return halfHeight_; }

 private:
  Point eye_;
  Frame frame_;
  int width_, height_;
  bool orthographic_;
  double halfHeight_;
};

/// The pose that sees exactly what the RT camera sees: its whole image (grid.columns : grid.rows) fits the picture, and
/// where the picture is at least as wide as the image the fields of view are equal.
ViewPose lookThroughPose(const Camera& camera, const PixelGrid& grid, int width, int height);

}  // namespace anamorph
