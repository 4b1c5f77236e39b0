// The kernel against memcpy of the same bytes, 1 million vertices, one thread; and against the map written
// down vertex by vertex, as the thesis' program has it.

#include <benchmark/benchmark.h>

#include <cstring>

#include "anamorphosis/map_points.h"
#include "anamorphosis/vertex_ray.h"
#include "ratios.h"
#include "shapes.h"

namespace anamorph {
namespace {

constexpr std::size_t vertices = 1'000'000;
const Point eye(0, -13, 8);

const PointArray& original() {
  static const PointArray points = [] {
    PointArray box(vertices);
    for (std::size_t i = 0; i < vertices; ++i) {  // a box behind all three mirrors
      const double a = static_cast<double>(i % 100) / 50 - 1, b = static_cast<double>(i / 100 % 100) / 50 - 1;
      box.set(i, {a, 6 + static_cast<double>(i) / vertices, 1 + b});
    }
    return box;
  }();
  return points;
}

Optic optic(int kind) {
  if (kind == 0)
    return {OpticKind::mirror,
            PlaneMirror{{Point(-8, 0, 0), Point(8, 0, 0), Point(8, 0, 8), Point(-8, 0, 8)}}};
  if (kind == 1) return {OpticKind::mirror, CylinderMirror{{0, 0, 0}, {0, 0, 10}, 3}};
  return {OpticKind::mirror, SphereMirror{{0, 0, 4}, 4}};
}

void copy(benchmark::State& state) {
  // Three arrays each way, as the kernel has them.
  const PointArray& from = original();
  PointArray to(vertices);
  for (auto _ : state) {
    std::memcpy(to.x.data(), from.x.data(), vertices * sizeof(double));
    std::memcpy(to.y.data(), from.y.data(), vertices * sizeof(double));
    std::memcpy(to.z.data(), from.z.data(), vertices * sizeof(double));
    benchmark::ClobberMemory();
  }
}

void deform(benchmark::State& state, int kind) {
  const Optic mirror = optic(kind);
  MappedPoints mapped;
  for (auto _ : state) {
    mapPointsThrough({mirror, eye, 0.4, {}}, original(), mapped, 1);
    benchmark::ClobberMemory();
  }
  if (countStatus(mapped.status)[0] != vertices) state.SkipWithError("not every vertex is mapped");
}

void oneByOne(benchmark::State& state, int kind) {
  const Optic mirror = optic(kind);
  PointArray mapped(vertices);
  for (auto _ : state) {
    for (std::size_t i = 0; i < vertices; ++i)
      mapped.set(i, mapPoint({mirror, eye, 0.4, {}}, original()[i]).point);
    benchmark::ClobberMemory();
  }
}

BENCHMARK(copy)->Name("memcpy 48 MB")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(deform, plane, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(deform, cylinder, 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(deform, sphere, 2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(oneByOne, cylinder, 1)->Unit(benchmark::kMillisecond);

const bool rows[] = {
    ratio("deform plane / memcpy", "deform/plane", "memcpy 48 MB", "<= 2.0"),
    ratio("deform cylinder / memcpy", "deform/cylinder", "memcpy 48 MB", "<= 3.0"),
    ratio("deform sphere / memcpy", "deform/sphere", "memcpy 48 MB", "<= 3.0"),
    ratio("one vertex after the other / kernel", "oneByOne/cylinder", "deform/cylinder", ">= 2.0"),
};

}  // namespace
}  // namespace anamorph
