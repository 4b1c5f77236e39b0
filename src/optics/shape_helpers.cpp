#include "optics/shape_helpers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/language.h"

namespace anamorph {

Direction facing(const Direction& normal, const Vector& ray) {
  return glm::dot(normal, ray) > 0 ? -normal : normal;
}

Direction wayOut(const Vector& outwards, const Vector& fromOriginal, const Direction& otherwise) {
  const auto usable = [](const Vector& v) { return isFinite(v) && glm::length(v) > 1e-9; };
  if (usable(outwards) && !(usable(fromOriginal) && glm::dot(outwards, fromOriginal) < 0)) {
    return glm::normalize(outwards);
  }
  return usable(fromOriginal) ? glm::normalize(fromOriginal) : otherwise;
}

Axes axesAlong(const Direction& a) {
  if (a.z < -1 + 1e-12) return {Direction(1, 0, 0), Direction(0, -1, 0), Direction(0, 0, -1)};
  const double f = 1 / (1 + a.z);
  const Direction x = glm::normalize(Vector(1 - f * a.x * a.x, -f * a.x * a.y, -a.x));
  return {x, glm::cross(a, x), a};
}

std::optional<std::string> findRadiusProblem(double radius) {
  if (radius > 0) return std::nullopt;
  return trFormat("expected a radius > 0, got {}", radius);
}

std::optional<std::string> findDistanceProblem(double distance, double size, const char* name) {
  if (!(distance > size * farthestEye)) return std::nullopt;
  return trFormat(
      "the mirror's {0} {1:.3g} is too small for an eye that is {2:.3g} away: nothing could be seen in it. "
      "Make the {0} larger, or move the eye nearer.",
      tr(name), size, distance);
}

std::optional<std::string> findContactProblem(double gap, double size) {
  if (gap > shapeTolerance * size) return std::nullopt;
  return tr(
      "the eye is on the surface of the mirror, from where nothing is seen in it. Move the eye away from the "
      "surface, to either side.");
}

std::optional<std::string> findLengthProblem(const char* name, double length) {
  if (length > 0) return std::nullopt;
  return trFormat("expected a {} > 0, got {}", tr(name), length);
}

Vector turnedBy(const ShapeMap& map, const Point& at, const Vector& way) {
  const double length = glm::length(way);
  const Direction was = way / length, is = glm::normalize(map.point(at + was) - map.point(at));
  return isFinite(is) && glm::length(is - was) > ShapeMap::notTurned ? length * is : way;
}

Direction around(const Direction& axis, double fraction) {
  const Direction x = perpendicular(axis), y = glm::cross(axis, x);
  const double angle = 2 * pi * fraction;
  return std::cos(angle) * x + std::sin(angle) * y;
}

double fillingRadius(const ShapeExtent& room, const Point& eye, double narrowing) {
  const Vector towards = eye - room.middle;
  const double along = glm::dot(towards, room.up), distance = glm::length(towards - along * room.up);
  if (!(distance > 1e-6)) return 0.5 * room.width;
  const double atEye = 1 - (1 - narrowing) * (along / room.height + 0.5);  // times as wide as at the bottom
  return std::min(0.5 * room.width, 0.5 * distance / std::max(1.0, atEye));
}

Box boxOfDiscs(const Point& a, double radiusA, const Point& b, double radiusB) {
  const Direction axis = glm::normalize(b - a);
  const Vector reach = glm::sqrt(glm::max(1.0 - axis * axis, Vector(0)));
  const Vector sound = isFinite(reach) ? reach : Vector(1);
  Box box;
  for (const auto& [centre, radius] : {std::pair{a, radiusA}, {b, radiusB}}) {
    box.extend(centre - radius * sound);
    box.extend(centre + radius * sound);
  }
  return box;
}

bool isUpright(const Vector& axis) {
  return std::hypot(axis.x, axis.y) < 1e-6 * glm::length(axis);
}

std::string stanceAlong(const Vector& axis) {
  const double lean = degrees(std::atan2(std::hypot(axis.x, axis.y), std::abs(axis.z)));
  if (lean < 0.05) return tr("Upright on the blue circle");
  return trFormat("Over the blue outline, leaning {:.1f} degrees", lean);
}

}  // namespace anamorph
