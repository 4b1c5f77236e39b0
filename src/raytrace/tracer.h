// The ray tracer: from a ray to its colour, by recursion (Whitted 1980). At a mesh or the ground one ray goes
// to every light; at the mirror one ray goes on in the reflected direction, `maxDepth` times at most. After
// that, the mirror shows the background.
//
// tracePath() writes down every ray it follows. It is the same function template as traceColor(), with a
// recorder that writes instead of one that does nothing, so what is drawn in the 3D view is what made the
// pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "math/ray.h"
#include "raytrace/scene.h"

namespace anamorph {

constexpr int maxTraceDepth = 8;

struct TraceOptions {
  int maxDepth = 3;  ///< reflections in a row, 0..maxTraceDepth
  bool shadows = true;
  double pixelAngle = 0;  ///< radians between neighbouring pixels; only softens the ground's grid lines
};

enum class RayKind : std::uint8_t {
  camera,     ///< from the eye to what it meets first
  reflected,  ///< from the mirror to what it meets
  light,      ///< from a surface to a light that reaches it
  shadow,     ///< from a surface towards a light, up to what is in between
  noHit,      ///< from the eye or the mirror into the background; drawn a few scene radii long
};

struct RaySegment {
  RayKind kind = RayKind::camera;
  int parent = -1;  ///< index of the ray that caused it; -1 for the ray from the eye
  int depth = 0;    ///< reflections before it
  ObjectId object;  ///< what it ends at; for light rays the light, for shadow rays the blocker
  Point from{0};
  Point to{0};
  Color weight{0};        ///< factor of its colour in the pixel
  Color contribution{0};  ///< weight * its colour: what the pixel would lose without it
};

/// Parents come before children. The first segment is the ray from the eye: its contribution is the pixel's
/// colour.
struct RayTree {
  std::vector<RaySegment> segments;
  Color color{0};
};

/// Linear colour seen along the ray; finite and >= 0 for a scene of finite numbers.
Color traceColor(const RenderScene& scene, const Ray& ray, const TraceOptions& options);

/// The same colour with the rays that made it.
RayTree tracePath(const RenderScene& scene, const Ray& ray, const TraceOptions& options);

}  // namespace anamorph
