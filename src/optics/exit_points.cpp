#include "optics/exit_points.h"

#include <algorithm>

#include "base/check.h"
#include "base/target_clones.h"
#include "optics/plane_mirror.h"
#include "optics/round_mirrors.h"

namespace anamorph {
namespace {

constexpr double grazingSineSquared = grazingSine * grazingSine * (1 + 1e-6);  // what is near it is not plain

struct SurfacePoint {
  double t;
  Vector normal;  // unit, towards either side
  bool onSurface;
};

// bounce(E, V) tells where the ray E + t V meets the surface.
template <typename Bounce>
[[gnu::always_inline]] inline std::size_t followAll(const Bounce& sharedBounce, const Point& sharedEye,
                                                    double depthScale, const double* px, const double* py,
                                                    const double* pz, std::size_t count, double* sx,
                                                    double* sy, double* sz, std::int64_t* plain) {
  const Bounce bounce = sharedBounce;  // copies that nothing written below can change
  const Point eye = sharedEye;
  std::int64_t plainCount = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector v = Point(px[i], py[i], pz[i]) - eye;
    const SurfacePoint hit = bounce(eye, v);
    const double across = glm::dot(v, hit.normal);
    const Vector reflected = v - 2 * across * hit.normal;
    const Point s = (eye + hit.t * v) + depthScale * (1 - hit.t) * reflected;
    sx[i] = s.x;
    sy[i] = s.y;
    sz[i] = s.z;
    const bool steep = across * across > grazingSineSquared * glm::dot(v, v);
    const std::int64_t isPlain = hit.onSurface & (hit.t > 0) & (hit.t <= 1) & steep;
    plain[i] = isPlain;
    plainCount += isPlain;
  }
  return static_cast<std::size_t>(plainCount);
}

// The two bounces are structs, not lambdas: only what is forced inline gets the clone's instruction set.
struct PlaneBounce {
  PlaneForm plane;
  double distance;  // from the eye to the plane

  [[gnu::always_inline]] SurfacePoint operator()(const Point& eye, const Vector& v) const {
    const double t = distance / glm::dot(plane.normal, v);
    return {t, plane.normal, plane.contains(eye + t * v)};
  }
};

// Outside a convex surface the first bounce is the only one, so nearRoot's case is plain.
template <typename Form>
struct RoundBounce {
  Form form;

  [[gnu::always_inline]] SurfacePoint operator()(const Point&, const Vector& v) const {
    const Vector u = form.across(v);
    const NearRoot root = nearRoot(form.w, u, form.c);
    const bool onSurface = root.valid & form.contains(root.t, v);
    return {root.t, (form.w + root.t * u) * form.inverseRadius, onSurface};
  }
};

PlaneBounce bounceOf(const PlaneMirror& mirror, const Point& eye) {
  const PlaneForm plane(mirror);
  return {plane, plane.distanceFrom(eye)};
}
RoundBounce<CylinderForm> bounceOf(const CylinderMirror& mirror, const Point& eye) {
  return {{mirror, eye}};
}
RoundBounce<SphereForm> bounceOf(const SphereMirror& mirror, const Point& eye) {
  return {{mirror, eye}};
}

// One loop a shape, so that each is compiled for each instruction set. That no array overlaps another has to
// be said at the parameters of the very function that holds the loop.
#define ANAMORPH_FOLLOW(Bounce)                                                                              \
  ANAMORPH_TARGET_CLONES                                                                                     \
  std::size_t follow(const Bounce& bounce, const Point& eye, double depthScale, const double* __restrict px, \
                     const double* __restrict py, const double* __restrict pz, std::size_t count,            \
                     double* __restrict sx, double* __restrict sy, double* __restrict sz,                    \
                     std::int64_t* __restrict plain) {                                                       \
    return followAll(bounce, eye, depthScale, px, py, pz, count, sx, sy, sz, plain);                         \
  }
ANAMORPH_FOLLOW(PlaneBounce)
ANAMORPH_FOLLOW(RoundBounce<CylinderForm>)
ANAMORPH_FOLLOW(RoundBounce<SphereForm>)
#undef ANAMORPH_FOLLOW

}  // namespace

std::size_t exitPoints(const Optic& optic, const Point& eye, double depthScale,
                       PointPointers<const double> targets, std::size_t count, PointPointers<double> points,
                       std::int64_t* plain) {
  CHECK(count <= exitBlockSize);
  if (optic.kind != OpticKind::mirror) {
    std::fill(plain, plain + count, 0);
    return 0;
  }
  return std::visit(
      [&](const auto& surface) -> std::size_t {
        if constexpr (requires { bounceOf(surface, eye); }) {
          return follow(bounceOf(surface, eye), eye, depthScale, targets.x, targets.y, targets.z, count,
                        points.x, points.y, points.z, plain);
        } else {  // a shape without a batch form: every ray is followed by itself
          std::fill(plain, plain + count, 0);
          return 0;
        }
      },
      optic.shape);
}

}  // namespace anamorph
