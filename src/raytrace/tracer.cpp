#include "raytrace/tracer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "raytrace/look.h"
#include "raytrace/scene_hit.h"
#include "raytrace/shading.h"

namespace anamorph {
namespace {

constexpr double noHitLength = 3;  // in scene radii

// What the image uses: every call vanishes.
struct NoRecorder {
  static constexpr bool records = false;
  int add(RayKind, int, const ObjectId&, const Point&, const Point&, const Color&) { return -1; }
  void finish(int, const Color&) {}
};

struct TreeRecorder {
  static constexpr bool records = true;
  std::vector<RaySegment> segments;

  // `factor`: of this ray's colour in its parent's.
  int add(RayKind kind, int parent, const ObjectId& object, const Point& from, const Point& to,
          const Color& factor) {
    RaySegment segment{kind, parent, 0, object, from, to, factor, Color(0)};
    if (parent >= 0) {
      segment.weight *= segments[parent].weight;
      segment.depth = segments[parent].depth + (kind == RayKind::reflected);
    }
    segments.push_back(segment);
    return static_cast<int>(segments.size()) - 1;
  }
  void finish(int segment, const Color& color) {
    segments[segment].contribution = segments[segment].weight * color;
  }
};

// A ray on its way, with what the recorder needs to know about its past.
struct Passage {
  Ray ray;
  RayKind kind = RayKind::camera;
  int depth = 0;
  double travelled = 0;  // from the eye to the ray's origin
  int parent = -1;
  Color factor{1};  // of its colour in its parent's
};

template <typename Recorder>
class Tracer {
 public:
  Tracer(const RenderScene& scene, const TraceOptions& options, Recorder& recorder)
      : scene_(scene), options_(options), recorder_(recorder) {}

  Color trace(const Passage& passage) {
    const Ray& ray = passage.ray;
    const auto hit = findHit(scene_, ray);
    const Point end = hit ? hit->point : ray.at(noHitLength * scene_.radius);
    const int self = recorder_.add(hit ? passage.kind : RayKind::noHit, passage.parent,
                                   hit ? hit->object : ObjectId{}, ray.origin, end, passage.factor);
    const Color color =
        hit ? shade(passage, *hit, self) : backgroundColor(scene_.input.background, ray.direction);
    recorder_.finish(self, color);
    return color;
  }

 private:
  Color shade(const Passage& passage, const SceneHit& hit, int self) {
    switch (hit.object.kind) {
      case ObjectKind::optic:
        return shadeMirror(passage, hit, self);
      case ObjectKind::ground:
        return shadeGround(passage, hit, self);
      default:
        return shadeSurface(scene_.input.surfaces[hit.object.index].material, passage.ray, hit, self, 1);
    }
  }

  Color shadeMirror(const Passage& passage, const SceneHit& hit, int self) {
    const OpticSurface& surface = *scene_.input.optic;
    const OpticHit met{{hit.t, hit.point, hit.normal}, static_cast<std::size_t>(hit.object.index)};
    const Direction out = glm::normalize(interact(surface.optic, passage.ray, met).direction);
    const double cosine = std::abs(glm::dot(passage.ray.direction, hit.normal));
    const double rim = look::rimStrength * mirrorRim(surface.optic.parts[met.part].shape, hit.point, cosine);
    const Color factor = (1 - rim) * surface.reflectance * surface.tint;
    const Color reflected = passage.depth < options_.maxDepth
                                ? trace({leave(hit, out), RayKind::reflected, passage.depth + 1,
                                         passage.travelled + hit.t, self, factor})
                                : backgroundColor(scene_.input.background, out);
    return factor * reflected + rim * look::rimColor;
  }

  Color shadeGround(const Passage& passage, const SceneHit& hit, int self) {
    const double slant = std::max(look::leastSlant, std::abs(passage.ray.direction.z));
    const double footprint = options_.pixelAngle * (passage.travelled + hit.t) / slant;
    const Material material = groundMaterial(*scene_.input.ground, hit.point, footprint);
    const Color lit = shadeSurface(material, passage.ray, hit, self, 1 - hit.groundFade);
    return lit + hit.groundFade * backgroundColor(scene_.input.background, passage.ray.direction);
  }

  // Ambient light and one ray to every light that is in front of the surface; all times `fraction`.
  Color shadeSurface(const Material& material, const Ray& ray, const SceneHit& hit, int self,
                     double fraction) {
    Color color = fraction * material.ambient * material.color;
    for (std::size_t i = 0; i < scene_.input.lights.size(); ++i) {
      const PointLight& light = scene_.input.lights[i];
      const Vector towards = light.position - hit.point;
      const double distance = glm::length(towards);
      if (!(distance > 0)) continue;
      const Color response = fraction * phongResponse(material, hit, towards / distance, -ray.direction);
      if (response == Color(0)) continue;
      color += lightThrough(light, static_cast<int>(i), hit, response, self);
    }
    return color;
  }

  Color lightThrough(const PointLight& light, int index, const SceneHit& hit, const Color& response,
                     int self) {
    const Point start = hit.point + scene_.epsilon * hit.faceNormal;
    const double distance = glm::length(light.position - start);
    const Ray ray{start, distance > 0 ? (light.position - start) / distance : hit.faceNormal};
    if (options_.shadows && isBlocked(scene_, ray, distance)) {
      if constexpr (Recorder::records) recordShadow(ray, distance, hit, response, self);
      return Color(0);
    }
    const Color lightColor = light.intensity * light.color;
    recorder_.finish(
        recorder_.add(RayKind::light, self, {ObjectKind::light, index}, hit.point, light.position, response),
        lightColor);
    return response * lightColor;
  }

  void recordShadow(const Ray& ray, double distance, const SceneHit& hit, const Color& response, int self) {
    const auto blocker = findHit(scene_, ray, distance);
    recorder_.add(RayKind::shadow, self, blocker ? blocker->object : ObjectId{}, hit.point,
                  blocker ? blocker->point : hit.point, response);
  }

  // Lifted off the surface, to the side that the ray came from and goes to.
  Ray leave(const SceneHit& hit, const Direction& direction) const {
    return {hit.point + scene_.epsilon * hit.faceNormal, direction};
  }

  const RenderScene& scene_;
  const TraceOptions& options_;
  Recorder& recorder_;
};

template <typename Recorder>
Color traceWith(Recorder& recorder, const RenderScene& scene, const Ray& ray, const TraceOptions& options) {
  CHECK(options.maxDepth >= 0 && options.maxDepth <= maxTraceDepth);
  return Tracer<Recorder>(scene, options, recorder).trace({ray});
}

}  // namespace

Color traceColor(const RenderScene& scene, const Ray& ray, const TraceOptions& options) {
  NoRecorder recorder;
  return traceWith(recorder, scene, ray, options);
}

RayTree tracePath(const RenderScene& scene, const Ray& ray, const TraceOptions& options) {
  TreeRecorder recorder;
  const Color color = traceWith(recorder, scene, ray, options);
  return {std::move(recorder.segments), color};
}

}  // namespace anamorph
