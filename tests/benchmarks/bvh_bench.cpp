// The tree against Embree's single-ray interface on the same mesh and rays, one thread: 98 000 triangles of a
// bumpy torus, seen directly and in a mirror sphere in its middle. "Hitting" leaves out the rays that meet
// nothing, which any tree answers fast.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "geometry/bvh.h"
#include "geometry/normals.h"
#include "math/frame.h"
#include "math/quadratic.h"
#include "ratios.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#define ANAMORPH_EMBREE 4
#elif __has_include(<embree3/rtcore.h>)
#include <embree3/rtcore.h>
#define ANAMORPH_EMBREE 3
#endif

namespace anamorph {
namespace {

constexpr int around = 350, across = 140;

Point torusPoint(double a, double b) {
  const double tube = 0.4 * (1 + 0.12 * std::sin(9 * a) * std::sin(7 * b) + 0.03 * std::sin(31 * a + 17 * b));
  const double ring = 1 + tube * std::cos(b);
  return {ring * std::cos(a), ring * std::sin(a), tube * std::sin(b)};
}

Mesh makeBumpyTorus() {
  Mesh mesh;
  const auto index = [](int i, int j) {
    return static_cast<std::uint32_t>(i % around * across + j % across);
  };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      mesh.positions.push_back(torusPoint(2 * pi * i / around, 2 * pi * j / across));
      mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return mesh;
}

const Mesh& torus() {
  static const Mesh mesh = makeBumpyTorus();
  return mesh;
}

const Bvh& torusBvh() {
  static const Bvh bvh(torus().positions, torus().triangles);
  return bvh;
}

std::vector<Ray> primaryRays(const Point& eye, int width = 640, int height = 360) {
  const Frame frame = makeFrame(glm::normalize(-eye), {0, 0, 1});
  const double slope = std::tan(radians(45) / 2) / (0.5 * height);
  std::vector<Ray> rays;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double right = slope * (x + 0.5 - 0.5 * width), up = slope * (0.5 * height - y - 0.5);
      rays.push_back({eye, glm::normalize(frame.forward + right * frame.right + up * frame.up)});
    }
  }
  return rays;
}

std::optional<Ray> reflectAtSphere(const Ray& ray, double radius) {
  const auto roots =
      solveQuadratic(1, glm::dot(ray.origin, ray.direction), lengthSquared(ray.origin) - radius * radius);
  if (!roots) return std::nullopt;
  const Point p = ray.at(roots->first);
  const Direction normal = p / radius;
  return Ray{p, ray.direction - 2 * glm::dot(ray.direction, normal) * normal};
}

std::vector<Ray> reflectedRays() {
  std::vector<Ray> rays;
  for (const Ray& ray : primaryRays({0, -2.2, 1.5})) {
    if (const auto reflected = reflectAtSphere(ray, 0.45)) rays.push_back(*reflected);
  }
  return rays;
}

std::vector<Ray> onlyHitting(const std::vector<Ray>& rays) {
  std::vector<Ray> hitting;
  BvhHit hit;
  for (const Ray& ray : rays) {
    if (torusBvh().closestHit(ray, hit)) hitting.push_back(ray);
  }
  return hitting;
}

/// Primary, primary hitting, reflected, reflected hitting.
const std::array<std::vector<Ray>, 4>& raySets() {
  static const std::array<std::vector<Ray>, 4> sets = [] {
    const std::vector<Ray> primary = primaryRays({0, -2.6, 2.2}), reflected = reflectedRays();
    return std::array{primary, onlyHitting(primary), reflected, onlyHitting(reflected)};
  }();
  return sets;
}

void build(benchmark::State& state) {
  for (auto _ : state) {
    const Bvh bvh(torus().positions, torus().triangles, 1);
    benchmark::DoNotOptimize(bvh.nodes().data());
  }
}

void refit(benchmark::State& state) {
  Bvh bvh = torusBvh();
  for (auto _ : state) bvh.refit(torus().positions, 1);
}

void normals(benchmark::State& state) {
  const NormalGroups groups = makeNormalGroups(torus());
  for (auto _ : state) {
    benchmark::DoNotOptimize(computeNormals(torus().positions, torus().triangles, groups));
  }
}

void normalGroups(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(makeNormalGroups(torus()));
}

#ifdef ANAMORPH_EMBREE

/// The torus as a committed Embree scene.
class Peer {
 public:
  explicit Peer(RTCDevice device, RTCBuildQuality quality = RTC_BUILD_QUALITY_MEDIUM)
      : scene_(rtcNewScene(device)), geometry_(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE)) {
    const Mesh& mesh = torus();
    points_ = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry_, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.positions.size()));
    auto* triangles = static_cast<Triangle*>(rtcSetNewGeometryBuffer(
        geometry_, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle), mesh.triangles.size()));
    std::copy(mesh.triangles.begin(), mesh.triangles.end(), triangles);
    rtcSetGeometryBuildQuality(geometry_, quality);
    if (quality == RTC_BUILD_QUALITY_REFIT) {  // which Embree does only for scenes like this
      rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
      rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
    }
    rtcAttachGeometry(scene_, geometry_);
    rtcReleaseGeometry(geometry_);
    commit();
  }

  /// Takes the points anew.
  void commit() {
    const PointArray& points = torus().positions;
    for (std::size_t i = 0; i < points.size(); ++i) {
      points_[3 * i] = static_cast<float>(points.x[i]);
      points_[3 * i + 1] = static_cast<float>(points.y[i]);
      points_[3 * i + 2] = static_cast<float>(points.z[i]);
    }
    rtcUpdateGeometryBuffer(geometry_, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
  }
  ~Peer() { rtcReleaseScene(scene_); }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  /// The distance, 0 for a miss.
  double closestHit(const Ray& ray) const {
    RTCRayHit r;
    r.ray.org_x = static_cast<float>(ray.origin.x);
    r.ray.org_y = static_cast<float>(ray.origin.y);
    r.ray.org_z = static_cast<float>(ray.origin.z);
    r.ray.dir_x = static_cast<float>(ray.direction.x);
    r.ray.dir_y = static_cast<float>(ray.direction.y);
    r.ray.dir_z = static_cast<float>(ray.direction.z);
    r.ray.tnear = 0;
    r.ray.tfar = std::numeric_limits<float>::infinity();
    r.ray.time = 0;
    r.ray.mask = 0xffffffffu;
    r.ray.flags = 0;
    r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if ANAMORPH_EMBREE == 3
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &r);
#else
    rtcIntersect1(scene_, &r);
#endif
    return r.hit.geomID == RTC_INVALID_GEOMETRY_ID ? 0 : static_cast<double>(r.ray.tfar);
  }

 private:
  RTCScene scene_;
  RTCGeometry geometry_;  // the scene keeps it alive
  float* points_;
};

RTCDevice device() {
  static RTCDevice device = rtcNewDevice("threads=1,user_threads=0");
  return device;
}

void embreeBuild(benchmark::State& state) {
  for (auto _ : state) {
    const Peer peer(device());
    benchmark::DoNotOptimize(&peer);
  }
}

void embreeRefit(benchmark::State& state) {
  Peer peer(device(), RTC_BUILD_QUALITY_REFIT);
  for (auto _ : state) peer.commit();
}

#endif

struct Seconds {
  double ours = 0, embrees = 0;
};

template <typename Trace>
double secondsFor(std::span<const Ray> rays, const Trace& trace) {
  const auto start = std::chrono::steady_clock::now();
  double sum = 0;
  for (const Ray& ray : rays) sum += trace(ray);
  benchmark::DoNotOptimize(sum);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void traceChunk(std::span<const Ray> rays, Seconds& seconds) {
  const Bvh& bvh = torusBvh();
  seconds.ours += secondsFor(rays, [&](const Ray& ray) {
    BvhHit hit;
    return bvh.closestHit(ray, hit) ? hit.t : 0;
  });
#ifdef ANAMORPH_EMBREE
  static const Peer peer(device());
  seconds.embrees += secondsFor(rays, [&](const Ray& ray) { return peer.closestHit(ray); });
#endif
}

/// Both trees by turns, a millisecond each: a machine that is busy with something else meanwhile slows both.
void traceRays(benchmark::State& state, int set) {
  const std::vector<Ray>& rays = raySets()[set];
  constexpr std::size_t chunk = 4000;
  Seconds seconds;
  for (auto _ : state) {
    for (std::size_t i = 0; i < rays.size(); i += chunk) {
      traceChunk(std::span(rays).subspan(i, std::min(chunk, rays.size() - i)), seconds);
    }
  }
  const double millions = 1e-6 * static_cast<double>(rays.size() * state.iterations());
  state.counters["Mrays/s"] = millions / seconds.ours;
  if (seconds.embrees > 0) {
    state.counters["Embree Mrays/s"] = millions / seconds.embrees;
    state.counters["of Embree"] = seconds.embrees / seconds.ours;
  }
}

bool registerAll() {
  using benchmark::RegisterBenchmark;
  const auto add = [](const char* name, auto... benchmark) {
    RegisterBenchmark(name, benchmark...)->Unit(benchmark::kMillisecond);
  };
  add("rays/primary", traceRays, 0);
  add("rays/primary hitting", traceRays, 1);
  add("rays/reflected", traceRays, 2);
  add("rays/reflected hitting", traceRays, 3);
  add("bvh/build", build);
  add("bvh/refit", refit);
#ifdef ANAMORPH_EMBREE
  add("embree/build", embreeBuild);
  add("embree/refit", embreeRefit);
#endif
  add("normals/groups", normalGroups);
  add("normals/compute", normals);
  return true;
}

const bool rows[] = {
    registerAll(),
    counter("rays as fast as Embree, primary", "rays/primary", "of Embree", ">= 0.75"),
    counter("rays as fast as Embree, primary hitting", "rays/primary hitting", "of Embree", ">= 0.75"),
    counter("rays as fast as Embree, reflected", "rays/reflected", "of Embree", ">= 0.75"),
    counter("rays as fast as Embree, reflected hitting", "rays/reflected hitting", "of Embree", ">= 0.75"),
    ratio("BVH build / Embree medium", "bvh/build", "embree/build", "<= 3.0"),
    ratio("BVH refit / Embree refit", "bvh/refit", "embree/refit", "<= 1.0"),
    milliseconds("BVH refit", "bvh/refit", "<= 1.5"),
    milliseconds("normals", "normals/compute", "<= 3.0"),
};

}  // namespace
}  // namespace anamorph
