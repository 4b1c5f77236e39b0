// The RT camera: a pinhole at the eye. Its image has square pixels, origin top-left, pixel centres at +0.5;
// the field of view is the vertical one.
#pragma once

#include <optional>

#include "math/frame.h"
#include "math/ray.h"

namespace anamorph {

struct Camera {
  Point eye{0, -10, 5};
  Point target{0, 0, 0};
  Direction up{0, 0, 1};  ///< need not be perpendicular to the line of sight, nor of length 1
  double fovDegrees = 45;

  bool operator==(const Camera&) const = default;
};

/// The RT camera's image with few pixels, drawn in the scene as a screen. Its columns and rows are the proportions
/// of every picture that the camera takes; where it is drawn changes nothing.
struct PixelGrid {
  int columns = 8;
  int rows = 8;
  double distance = 1;  ///< from the eye, scene units

  bool operator==(const PixelGrid&) const = default;
};

/// A camera with an image size: turns pixels into rays and points into pixels.
class Projection {
 public:
  /// Width and height in pixels, both > 0. An eye at the target looks along +y.
  Projection(const Camera& camera, int width, int height);

  /// From the eye through an image position.
  Ray rayThrough(const Pixel& pixel) const;

  /// Where a point is seen; nothing when it is not in front of the eye.
  std::optional<Pixel> pixelOf(const Point& point) const;

  const Point& eye() const { return eye_; }
  const Frame& frame() const { return frame_; }
  int width() const { return width_; }
  int height() const { return height_; }
  /// Pixels per radian at the image's centre: height / (2 tan(fov / 2)).
  double pixelsPerTangent() const { return scale_; }

 private:
  Point eye_;
  Frame frame_;
  int width_, height_;
  double scale_;
};

}  // namespace anamorph
