// Where a ray meets the scene: the nearest of its meshes, its optic and its ground. No colours here
// (shading.h).
#pragma once

#include <limits>
#include <optional>

#include "math/ray.h"
#include "raytrace/scene.h"

namespace anamorph {

struct SceneHit {
  ObjectId object;
  double t = 0;             ///< along the ray
  Point point{0};           ///< on the surface
  Direction faceNormal{0};  ///< of the surface itself, towards the ray's origin
  Direction normal{0};      ///< smooth, to shade with; on the same side as faceNormal
  double groundFade = 0;    ///< 0..1, how much of the ground has become background here
};

/// The first object in front of the ray's origin, nearer than tMax; nothing when the ray leaves the scene.
std::optional<SceneHit> findHit(const RenderScene& scene, const Ray& ray,
                                double tMax = std::numeric_limits<double>::infinity());

/// Whether anything lies on the ray before tMax: what findHit() says, without asking what is nearest.
bool isBlocked(const RenderScene& scene, const Ray& ray, double tMax);

}  // namespace anamorph
