#include "edit/camera_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "optics/camera.h"

namespace anamorph {

double rtCameraSize(const PixelGrid& grid, double sceneRadius) {
  constexpr double step = 1.1;
  const double size = 0.05 * std::pow(step, std::round(std::log(sceneRadius) / std::log(step)));
  return grid.distance > 0 ? std::min(size, 0.6 * grid.distance) : size;
}

std::optional<double> intersectRtCamera(const Camera& camera, double size, const Ray& ray) {
  const Frame frame = Projection(camera, 1, 1).frame();
  const auto turned = [&](const Vector& v) {
    return Vector(glm::dot(v, frame.right), glm::dot(v, frame.up), glm::dot(v, frame.forward));
  };
  const Point origin = turned(ray.origin - camera.eye) / size;
  const Vector way = turned(ray.direction) / size;
  double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = (rtCameraBody.min[axis] - origin[axis]) / way[axis],
                 high = (rtCameraBody.max[axis] - origin[axis]) / way[axis];
    enter = std::max(enter, std::min(low, high));
    leave = std::min(leave, std::max(low, high));
  }
  return enter > 0 && enter <= leave && std::isfinite(enter) ? std::optional(enter) : std::nullopt;
}

}  // namespace anamorph
