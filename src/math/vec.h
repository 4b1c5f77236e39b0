// Points, vectors and directions: three doubles each (glm::dvec3). The names say what a value means; a Direction
// has length 1. Right-handed frame, z up. Core numbers are double: float appears only in the BVH and on the GPU.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace anamorph {

using Point = glm::dvec3;
using Vector = glm::dvec3;
using Direction = glm::dvec3;  ///< of length 1
using Pixel = glm::dvec2;      ///< image position, origin top-left, x right, y down; pixel centres at +0.5
using Color = glm::dvec3;      ///< linear RGB, 0..1 when displayable

constexpr double pi = 3.14159265358979323846;

inline double radians(double degrees) { return degrees * (pi / 180); }
inline double degrees(double rad) { return rad * (180 / pi); }

inline bool isFinite(const Vector& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

inline double lengthSquared(const Vector& v) { return glm::dot(v, v); }

}  // namespace anamorph
