#include "edit/orbit.h"

#include <algorithm>
#include <cmath>

#include "level/limits.h"

namespace anamorph {
namespace {

const Direction z(0, 0, 1);
constexpr double levelTolerance = 1e-6;  // of the sine of the picture's tilt
constexpr double frameMargin = 1.08;     // a framed box leaves a little air

double distanceOf(const ViewPose& pose) {
  return glm::length(pose.eye - pose.target);
}

double tangentOf(const ViewPose& pose) {
  return std::tan(radians(pose.fovDegrees) / 2);
}

// The axis that an orbit turns about.
Direction poleOf(const ViewPose& pose, const Frame& frame) {
  if (std::abs(frame.right.z) < levelTolerance) return frame.up.z < -levelTolerance ? -z : z;
  const Direction up = glm::normalize(pose.up);
  const bool usable =
      std::abs(glm::dot(up, frame.right)) < levelTolerance &&
      std::abs(glm::dot(up, frame.forward)) < 1 - levelTolerance;  // not along the line of sight
  return usable ? up : frame.up;
}

// How much nearer some steps of the wheel may bring it.
double zoomFactor(double distance, double steps) {
  if (!std::isfinite(steps)) return 1;
  const double wanted = distance * std::pow(zoomPerStep, -std::clamp(steps, -1000.0, 1000.0));
  return std::clamp(wanted, minViewDistance, maxViewDistance) / distance;
}

}  // namespace

ViewPose soundPose(const ViewPose& pose) {
  ViewPose sound = pose;
  const ViewPose usual;
  if (!isFinite(sound.target)) sound.target = usual.target;
  if (!isFinite(sound.up) || !(glm::length(sound.up) > 1e-9)) sound.up = usual.up;
  if (!std::isfinite(sound.fovDegrees)) sound.fovDegrees = usual.fovDegrees;
  sound.fovDegrees = std::clamp(sound.fovDegrees, limits::poseFieldOfView.min, limits::poseFieldOfView.max);
  if (!isFinite(sound.eye)) sound.eye = sound.target + (usual.eye - usual.target);
  const double distance = distanceOf(sound);
  if (!(distance > 0))
    sound.eye = sound.target - Vector(0, minViewDistance, 0);  // ViewProjection looks along +y
  return sound;
}

Frame frameOf(const ViewPose& pose) {
  const ViewPose sound = soundPose(pose);
  return makeFrame(glm::normalize(sound.target - sound.eye), glm::normalize(sound.up));
}

bool isLevel(const ViewPose& pose) {
  const Frame frame = frameOf(pose);
  return std::abs(frame.right.z) < levelTolerance && frame.up.z > -levelTolerance;
}

ViewPose upright(const ViewPose& pose) {
  ViewPose level = soundPose(pose);
  if (isLevel(level)) return level;
  const Vector sight = glm::normalize(level.target - level.eye);
  // Straight up or down every direction is level: the picture stays as it is.
  level.up = glm::length(glm::cross(sight, z)) > levelTolerance ? z : frameOf(level).up;
  return level;
}

//       pole                forward = cos(pitch) ahead - sin(pitch) pole
//        |  .eye            right, ahead and pole are perpendicular; yaw turns the first two about the pole
//        |.' pitch
//        +------- -ahead
ViewPose orbit(const ViewPose& pose, double dxPixels, double dyPixels) {
  if (!std::isfinite(dxPixels) || !std::isfinite(dyPixels) || (dxPixels == 0 && dyPixels == 0))
    return soundPose(pose);
  ViewPose turned = soundPose(pose);
  const Frame frame = frameOf(turned);
  const Direction pole = poleOf(turned, frame);
  const Direction ahead = glm::cross(pole, frame.right);
  const double yaw = radians(std::remainder(-dxPixels * orbitDegreesPerPixel, 360.0));
  const Direction aheadNow = std::cos(yaw) * ahead - std::sin(yaw) * frame.right;
  const double limit = radians(orbitMaxPitchDegrees);
  double pitch = std::atan2(-glm::dot(frame.forward, pole), glm::dot(frame.forward, ahead));
  pitch = std::clamp(pitch + radians(dyPixels * orbitDegreesPerPixel), -limit, limit);
  const Direction forward = glm::normalize(std::cos(pitch) * aheadNow - std::sin(pitch) * pole);
  turned.eye = turned.target - distanceOf(turned) * forward;
  turned.up = pole;
  return turned;
}

ViewPose pan(const ViewPose& pose, const ViewProjection& projection, double dxPixels, double dyPixels) {
  ViewPose moved = soundPose(pose);
  const Frame frame = frameOf(moved);
  const double unit = projection.unitsPerPixel(moved.target);
  const Vector shift = unit * (dyPixels * frame.up - dxPixels * frame.right);
  if (!isFinite(shift)) return moved;
  moved.eye += shift;
  moved.target += shift;
  return moved;
}

ViewPose keptAbove(double floor, const ViewPose& pose, const std::function<ViewPose(double)>& moved) {
  const ViewPose whole = moved(1);
  if (!(pose.eye.z > floor) || whole.eye.z > floor) return whole;
  double above = 0, below = 1;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (above + below);
    (moved(middle).eye.z > floor ? above : below) = middle;
  }
  return moved(above);
}

ViewPose zoomTo(const ViewPose& pose, const ViewProjection& projection, const Pixel& pixel, double steps) {
  const ViewPose sound = soundPose(pose);
  const Ray ray = projection.rayThrough(pixel);
  const Direction forward = frameOf(sound).forward;
  const double t = glm::dot(sound.target - ray.origin, forward) / glm::dot(ray.direction, forward);
  const Point point = ray.at(t);
  return zoomTowards(sound, isFinite(point) ? point : sound.target, steps);
}

// Everything shrinks towards the point, so the ray on which it is seen stays the same.
ViewPose zoomTowards(const ViewPose& pose, const Point& point, double steps) {
  ViewPose zoomed = soundPose(pose);
  const double factor = zoomFactor(distanceOf(zoomed), steps);
  if (factor == 1 || !isFinite(point)) return zoomed;
  zoomed.eye = point + factor * (zoomed.eye - point);
  zoomed.target = point + factor * (zoomed.target - point);
  return zoomed;
}

ViewPose setCentre(const ViewPose& pose, const Point& point) {
  ViewPose centred = soundPose(pose);
  if (!isFinite(point)) return centred;
  centred.eye = point + (centred.eye - centred.target);
  centred.target = point;
  return centred;
}

ViewPose frameBox(const ViewPose& pose, const Box& box, double aspect) {
  ViewPose framed = soundPose(pose);
  if (box.empty() || !isFinite(box.min) || !isFinite(box.max)) return framed;
  framed = setCentre(framed, box.centre());
  if (!(box.diagonal() > 0) || !(aspect > 0)) return framed;
  const Frame frame = frameOf(framed);
  const double tangent = tangentOf(framed);
  double distance = 0;
  for (int i = 0; i < 8; ++i) {
    const Point corner(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y,
                       i & 4 ? box.max.z : box.min.z);
    const Vector v = corner - framed.target;
    const double across =
        std::max(std::abs(glm::dot(v, frame.up)), std::abs(glm::dot(v, frame.right)) / aspect);
    const double nearer = -glm::dot(v, frame.forward), away = frameMargin * across / tangent;
    // Parallel rays: the eye only has to be before the box.
    distance = std::max(distance, framed.orthographic ? std::max(away, nearer) : away + nearer);
  }
  distance = std::clamp(distance, minViewDistance, maxViewDistance);
  framed.eye = framed.target - distance * frame.forward;
  return framed;
}

ViewPose viewFrom(const ViewPose& pose, ViewSide side) {
  ViewPose seen = soundPose(pose);
  const double distance = distanceOf(seen);
  const auto look = [&](const Direction& towardsEye, const Direction& up) {
    seen.eye = seen.target + distance * towardsEye;
    seen.up = up;
    return seen;
  };
  switch (side) {
    case ViewSide::front:
      return look({0, -1, 0}, z);
    case ViewSide::back:
      return look({0, 1, 0}, z);
    case ViewSide::left:
      return look({-1, 0, 0}, z);
    case ViewSide::right:
      return look({1, 0, 0}, z);
    case ViewSide::top:
      return look(z, {0, 1, 0});
    case ViewSide::bottom:
      return look(-z, {0, -1, 0});
  }
  return seen;
}

ViewPose togglePerspective(const ViewPose& pose) {
  ViewPose toggled = pose;
  toggled.orthographic = !toggled.orthographic;
  return toggled;
}

}  // namespace anamorph
