// What a frame of a drag has to compute, for a mesh as large as the largest of the thesis (49 k vertices, 98
// k triangles): new vertices, new normals, new boxes. And what follows on release, for every installed level.

#include <benchmark/benchmark.h>

#include "anamorphosis/match.h"
#include "geometry/shapes.h"
#include "level/level_json.h"
#include "level/level_library.h"
#include "optics/cone.h"
#include "optics/ellipsoid.h"
#include "optics/extrusion.h"
#include "optics/paraboloid.h"
#include "optics/patch.h"
#include "optics/revolution.h"
#include "pipeline/evaluator.h"
#include "pipeline/original.h"
#include "pipeline/picture.h"
#include "ratios.h"
#include "shapes.h"

namespace anamorph {
namespace {

// Of the cylinder: 100 000 triangles.
Shape asTriangles(const CylinderMirror& cylinder) {
  SmoothMesh surface = tessellateGrid(
      500, 100, [&](double u, double v) { return cylinder.pointAt(u, v); },
      [&](double u, double) { return around(cylinder.axis(), u); });
  return meshMirror(std::move(surface));
}

constexpr Point eye{0, -13.6, 9.8};

// Before the eye, as large as the cylinder and wider: every vertex meets it.
const ShapeExtent room{{0, 0, 5}, {0, 0, 1}, 14, 10};

void liveStep(benchmark::State& state, const Shape& mirror) {
  const int threads = static_cast<int>(state.range(0));
  Mesh knot = makeTorusKnot(2, 3, 0.25, 980, 50);  // 49 000 vertices
  knot.positions = mapPoints(knot.positions, [](const Point& p) { return Point(0, 5.4, 1.5) + p; });
  DeformInput input;
  input.original = std::make_shared<const Mesh>(knot);
  input.map.optic.shape() = mirror;
  input.map.eye = input.camera.eye = eye;
  input.camera.target = {0, 5.4, 1.5};
  input.tolerancePixels = 0;
  Sculpture sculpture = makeSculpture(input);
  input.map.depthScale = 0.4;
  const NormalGroups groups = makeNormalGroups(sculpture.mesh);
  Bvh bvh(sculpture.mesh.positions, sculpture.mesh.triangles, threads);
  for (auto _ : state) {
    input.map.eye.x += 0.001;
    remapSculpture(input.map, sculpture, threads);
    benchmark::DoNotOptimize(
        computeNormals(sculpture.mesh.positions, sculpture.mesh.triangles, groups, threads));
    bvh.refit(sculpture.mesh.positions, threads);
  }
  state.counters["triangles"] = static_cast<double>(sculpture.mesh.triangles.size());
}

void release(benchmark::State& state, const char* name) {
  const std::string path = std::string(ANAMORPH_LEVELS) + "/" + name + ".json";
  const Level level = loadLevel(path).level;
  const auto shape = loadOriginal(level.original.shape, path).mesh;
  const auto original = placeOriginal(*shape, level.original.unitize, level.original.placement);
  for (auto _ : state) {
    const auto finished = finishLevel(level, original, 0);
    benchmark::DoNotOptimize(
        computeMatch(makeMatchInput(level, finished->original, finished->sculpture, 512, 512), 0).report);
  }
}

#define LIVE_STEP(name, mirror) \
  BENCHMARK_CAPTURE(liveStep, name, mirror)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()
LIVE_STEP(cylinder, (CylinderMirror{{0, 0, 0}, {0, 0, 10}, 3}));
LIVE_STEP(sphere, (SphereMirror{{0, 0, 4}, 4}));
LIVE_STEP(cone, (ConeMirror{{0, 0, 0}, {0, 0, 10}, 3, 1.5}));
LIVE_STEP(ellipsoid, (EllipsoidMirror{{0, 0, 4}, {4, 4.5, 5}, {0, 0, 10}}));
LIVE_STEP(paraboloid, (ParaboloidMirror{{0, 2, 5}, {0, -1, 0}, 8, 7}));
LIVE_STEP(revolution, RevolutionMirror::filling(room, eye));
LIVE_STEP(extrusion, ExtrusionMirror::filling(room, eye));
LIVE_STEP(patch, PatchMirror::filling(room, eye));
LIVE_STEP(mesh, asTriangles(CylinderMirror{{0, 0, 0}, {0, 0, 10}, 3}));
BENCHMARK_CAPTURE(release, plane, "1-plane")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(release, cylinder, "2-cylinder")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(release, sphere, "3-sphere")->Unit(benchmark::kMillisecond)->UseRealTime();

const bool rows[] = {
    milliseconds("live step, 98 k triangles, 1 thread", "liveStep/cylinder/1/real_time", "<= 8.0"),
    milliseconds("live step, 98 k triangles, 2 threads", "liveStep/cylinder/2/real_time", "<= 8.0"),
    ratio("live step, cone / sphere", "liveStep/cone/2/real_time", "liveStep/sphere/2/real_time", "<= 3.0"),
    ratio("live step, ellipsoid / sphere", "liveStep/ellipsoid/2/real_time", "liveStep/sphere/2/real_time",
          "<= 3.0"),
    ratio("live step, paraboloid / sphere", "liveStep/paraboloid/2/real_time", "liveStep/sphere/2/real_time",
          "<= 3.0"),
    milliseconds("live step, turned profile, 2 threads", "liveStep/revolution/2/real_time", "<= 25.0"),
    milliseconds("live step, curved wall, 2 threads", "liveStep/extrusion/2/real_time", "<= 25.0"),
    milliseconds("live step, curved patch, 2 threads", "liveStep/patch/2/real_time", "<= 25.0"),
    milliseconds("live step, mirror of 100 k triangles, 2 threads", "liveStep/mesh/2/real_time", "<= 40"),
    milliseconds("refine and match at 512, plane", "release/plane/real_time", "<= 1000"),
    milliseconds("refine and match at 512, cylinder", "release/cylinder/real_time", "<= 1000"),
    milliseconds("refine and match at 512, sphere", "release/sphere/real_time", "<= 1000"),
};

}  // namespace
}  // namespace anamorph
