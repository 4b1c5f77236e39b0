// What a window costs while nobody touches it: a real one, on a screen of its own. It draws nothing then (a test
// looks); this is what watching for events and files takes.

#include <benchmark/benchmark.h>

#include <string>

#include "app/virtual_window.h"
#include "ratios.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;

void idle(benchmark::State& state) {
  if (!isInstalled("Xvfb")) return state.SkipWithError("Xvfb is not installed");
  VirtualWindow window({std::string(ANAMORPH_LEVELS) + "/2-cylinder.json", "--size", "1000x700"});
  if (!window.settle() || !window.rest()) return state.SkipWithError("the window does not come to rest");
  double busy = 0, seconds = 0;
  for (auto _ : state) {
    const double begin = secondsOfClock(), before = window.program().cpuSeconds();
    sleepFor(3);
    busy += window.program().cpuSeconds() - before;
    seconds += secondsOfClock() - begin;
  }
  state.counters["percent"] = 100 * busy / seconds;
}

BENCHMARK(idle)->Name("window at rest")->Iterations(1)->Repetitions(1)->UseRealTime();

const bool rows[] = {
    counter("window at rest, % of a processor", "window at rest/iterations:1/repeats:1/real_time", "percent",
            "<= 2.4"),
};

}  // namespace
}  // namespace anamorph
