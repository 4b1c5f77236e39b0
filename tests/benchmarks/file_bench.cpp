// A large model from file to file: a 98 MB OBJ with 981 k vertices is read, deformed and written, as
// `anamorph deform --tolerance off` does it.

#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>

#include "anamorphosis/sculpture.h"
#include "geometry/mesh_files.h"
#include "geometry/shapes.h"
#include "ratios.h"
#include "shapes.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

// Written once a run; removed at its end.
class LargeModel {
 public:
  LargeModel() : path_(fs::temp_directory_path() / "anamorph-bench.obj") {
    Mesh knot = makeTorusKnot(2, 3, 0.25, 9810, 100);
    knot.positions = mapPoints(knot.positions, [](const Point& p) { return Point(0, 5, 2) + p; });
    saveMesh(path_, knot);
  }
  ~LargeModel() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  LargeModel(const LargeModel&) = delete;
  LargeModel& operator=(const LargeModel&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void fileToFile(benchmark::State& state) {
  const LargeModel model;
  const fs::path out = fs::temp_directory_path() / "anamorph-bench-out.obj";
  DeformInput input;
  input.map.optic.shape() = CylinderMirror{{0, 0, 0}, {0, 0, 8}, 3};
  input.map.eye = input.camera.eye = {0, -12, 8};
  input.tolerancePixels = 0;
  for (auto _ : state) {
    input.original = std::make_shared<const Mesh>(loadMesh(model.path()).mesh);
    saveMesh(out, makeSculpture(input, 0).mesh);
  }
  state.counters["MB"] = static_cast<double>(fs::file_size(model.path())) * 1e-6;
  fs::remove(out);
}

BENCHMARK(fileToFile)->Name("file to file")->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

const bool rows[] = {milliseconds("98 MB OBJ, 981 k vertices, file to file",
                                  "file to file/iterations:1/real_time", "<= 2500")};

}  // namespace
}  // namespace anamorph
