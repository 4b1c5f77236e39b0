#include "edit/pose_flight.h"

#include <cmath>

#include <glm/gtc/quaternion.hpp>

#include "edit/orbit.h"

namespace anamorph {
namespace {

// The picture's axes as a rotation of x (right), y (ahead), z (up).
glm::dquat rotationOf(const Frame& frame) {
  return glm::quat_cast(glm::dmat3(frame.right, frame.forward, frame.up));
}

// Of a level frame: the angle of its right-hand axis about z, and how much it looks down. Defined even where
// it looks straight down.
struct Heading {
  double azimuth, pitch;
};
Heading headingOf(const Frame& frame) {
  const Direction ahead(-frame.right.y, frame.right.x, 0);
  return {std::atan2(frame.right.y, frame.right.x),
          std::atan2(-frame.forward.z, glm::dot(frame.forward, ahead))};
}

Frame levelFrame(const Heading& heading) {
  const Direction right(std::cos(heading.azimuth), std::sin(heading.azimuth), 0), ahead(-right.y, right.x, 0);
  const double c = std::cos(heading.pitch), s = std::sin(heading.pitch);
  return {right, s * ahead + Vector(0, 0, c), c * ahead - Vector(0, 0, s)};
}

Frame between(const ViewPose& from, const ViewPose& goal, double fraction) {
  const Frame a = frameOf(from), b = frameOf(goal);
  if (isLevel(from) && isLevel(goal)) {
    const Heading start = headingOf(a), end = headingOf(b);
    const double turn = std::remainder(end.azimuth - start.azimuth, 2 * pi);
    return levelFrame({start.azimuth + fraction * turn, glm::mix(start.pitch, end.pitch, fraction)});
  }
  const glm::dmat3 axes = glm::mat3_cast(glm::normalize(glm::slerp(rotationOf(a), rotationOf(b), fraction)));
  return {axes[0], axes[2], axes[1]};
}

double mixedFov(double from, double goal, double fraction) {
  const auto tangent = [](double angle) { return std::tan(radians(angle) / 2); };
  return degrees(2 * std::atan(glm::mix(tangent(from), tangent(goal), fraction)));
}

}  // namespace

ViewPose PoseFlight::poseAt(double seconds) const {
  if (endedAt(seconds)) return goal;
  if (!(seconds > 0)) return from;
  const double time = seconds / duration, fraction = time * time * (3 - 2 * time);
  const ViewPose start = soundPose(from), end = soundPose(goal);
  const Frame frame = between(start, end, fraction);
  const double startDistance = glm::length(start.eye - start.target),
               endDistance = glm::length(end.eye - end.target);
  ViewPose pose = end;
  pose.target = glm::mix(start.target, end.target, fraction);
  pose.eye = pose.target - startDistance * std::pow(endDistance / startDistance, fraction) * frame.forward;
  pose.up = frame.up;
  pose.fovDegrees = mixedFov(start.fovDegrees, end.fovDegrees, fraction);
  return pose;
}

PoseFlight retargeted(const PoseFlight& flight, double seconds, const ViewPose& goal) {
  return {flight.poseAt(seconds), goal, flight.duration};
}

}  // namespace anamorph
