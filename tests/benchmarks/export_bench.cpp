// What a maker waits for: the print check of a sculpture of 200 000 triangles, measured in times that its BVH is
// built in, and the viewing sheet.

#include <benchmark/benchmark.h>

#include <string>

#include "exports/arrangement.h"
#include "exports/page_file.h"
#include "exports/print_check.h"
#include "exports/viewing_sheet.h"
#include "geometry/bvh.h"
#include "geometry/shapes.h"
#include "level/level_json.h"
#include "pipeline/evaluator.h"
#include "pipeline/original.h"
#include "ratios.h"

namespace anamorph {
namespace {

const Mesh& solid() {
  static const Mesh mesh = makeTorusKnot(2, 3, 0.25, 2000, 50);
  return mesh;
}

void buildBvh(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(Bvh(solid().positions, solid().triangles, 0));
  state.counters["triangles"] = static_cast<double>(solid().triangles.size());
}

void checkForPrinting(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(checkPrint(solid(), 0));
}

void drawSheet(benchmark::State& state) {
  const Level level = loadLevel(std::string(ANAMORPH_LEVELS) + "/3-sphere.json").level;
  const auto original = placeOriginal(*loadOriginal(level.original.shape, {}).mesh, level.original.unitize,
                                      level.original.placement);
  const LevelResult finished = *finishLevel(level, original, 0, {});
  for (auto _ : state) {
    const Arrangement arrangement = makeArrangement(finished, 10);
    const ViewingSheet sheet = makeViewingSheet(finished, arrangement, Paper::a4, std::nullopt);
    benchmark::DoNotOptimize(encodePage(sheet.page, PageFormat::pdf));
  }
}

BENCHMARK(buildBvh)->Name("export/bvh")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(checkForPrinting)->Name("export/print check")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(drawSheet)->Name("export/viewing sheet")->Unit(benchmark::kMillisecond)->UseRealTime();

const bool rows[] = {
    ratio("print check / BVH of the sculpture", "export/print check/real_time", "export/bvh/real_time",
          "<= 10"),
    milliseconds("viewing sheet of the sphere level", "export/viewing sheet/real_time", "<= 250"),
};

}  // namespace
}  // namespace anamorph
