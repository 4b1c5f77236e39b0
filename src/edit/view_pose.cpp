#include "edit/view_pose.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace anamorph {

ViewProjection::ViewProjection(const ViewPose& pose, int width, int height)
    : eye_(pose.eye), width_(width), height_(height), orthographic_(pose.orthographic) {
  CHECK(width > 0 && height > 0);
  const Vector towards = pose.target - pose.eye;
  const double distance = glm::length(towards);
  frame_ = makeFrame(distance > 0 ? towards / distance : Direction(0, 1, 0), glm::normalize(pose.up));
  halfHeight_ = std::tan(radians(pose.fovDegrees) / 2) * (orthographic_ ? std::max(distance, 1e-9) : 1.0);
}

Ray ViewProjection::rayThrough(const Pixel& pixel) const {
  const double unit = 2 * halfHeight_ / height_;
  const double x = (pixel.x - 0.5 * width_) * unit, y = (0.5 * height_ - pixel.y) * unit;
  const Vector across = x * frame_.right + y * frame_.up;
  if (orthographic_) return {eye_ + across, frame_.forward};
  return {eye_, glm::normalize(frame_.forward + across)};
}

std::optional<Pixel> ViewProjection::pixelOf(const Point& point) const {
  const Vector v = point - eye_;
  const double depth = glm::dot(v, frame_.forward);
  if (!orthographic_ && !(depth > 0)) return std::nullopt;
  const double scale = 0.5 * height_ / (halfHeight_ * (orthographic_ ? 1 : depth));
  return Pixel(0.5 * width_ + scale * glm::dot(v, frame_.right),
               0.5 * height_ - scale * glm::dot(v, frame_.up));
}

double ViewProjection::unitsPerPixel(const Point& point) const {
  const double depth = orthographic_ ? 1 : std::abs(glm::dot(point - eye_, frame_.forward));
  return 2 * halfHeight_ * std::max(depth, 1e-9) / height_;
}

ViewPose lookThroughPose(const Camera& camera, const PixelGrid& grid, int width, int height) {
  ViewPose pose{camera.eye, camera.target, camera.up, camera.fovDegrees, false};
  if (!(lengthSquared(camera.target - camera.eye) > 0)) pose.target = camera.eye + Direction(0, 1, 0);
  const double imageAspect = double(grid.columns) / grid.rows;
  const double viewAspect = double(width) / height;
  if (viewAspect < imageAspect) {  // too narrow: the whole image has to fit
    const double half = std::tan(radians(camera.fovDegrees) / 2) * imageAspect / viewAspect;
    pose.fovDegrees = degrees(2 * std::atan(half));
  }
  return pose;
}

}  // namespace anamorph
