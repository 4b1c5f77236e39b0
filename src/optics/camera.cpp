#include "optics/camera.h"

#include "base/check.h"

namespace anamorph {

Projection::Projection(const Camera& camera, int width, int height)
    : eye_(camera.eye), width_(width), height_(height) {
  CHECK(width > 0 && height > 0);
  const Vector towards = camera.target - camera.eye;
  const double distance = glm::length(towards);
  const double upLength = glm::length(camera.up);
  frame_ = makeFrame(distance > 0 ? towards / distance : Direction(0, 1, 0),
                     upLength > 0 ? camera.up / upLength : Direction(0, 0, 1));
  scale_ = height / (2 * std::tan(radians(camera.fovDegrees) / 2));
}

Ray Projection::rayThrough(const Pixel& pixel) const {
  const double x = (pixel.x - 0.5 * width_) / scale_, y = (0.5 * height_ - pixel.y) / scale_;
  return {eye_, glm::normalize(frame_.forward + x * frame_.right + y * frame_.up)};
}

std::optional<Pixel> Projection::pixelOf(const Point& point) const {
  const Vector v = point - eye_;
  const double depth = glm::dot(v, frame_.forward);
  if (!(depth > 0)) return std::nullopt;
  return Pixel(0.5 * width_ + scale_ * glm::dot(v, frame_.right) / depth,
               0.5 * height_ - scale_ * glm::dot(v, frame_.up) / depth);
}

}  // namespace anamorph
