#include "ratios.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace anamorph {
namespace {

/// One row. Its figure is figures[numerator] / figures[denominator]; without a denominator it is the
/// numerator.
struct Row {
  std::string name;
  std::string numerator;
  std::string denominator;
  std::string unit;
  std::string target;
};

std::vector<Row>& rows() {
  static std::vector<Row> all;  // registered before main
  return all;
}

bool addRow(Row row) {
  rows().push_back(std::move(row));
  return true;
}

std::string counterKey(const std::string& benchmark, const std::string& counter) {
  return benchmark + ": " + counter;
}

/// Prints as usual and keeps the milliseconds of an iteration, and the counters; of several repetitions the
/// median.
class Recorder : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      const bool single = run.run_type == Run::RT_Iteration && run.repetitions <= 1;
      const bool median = run.run_type == Run::RT_Aggregate && run.aggregate_name == "median";
      if (!run.error_occurred && (single || median)) record(run);
    }
  }

  /// Nothing when one of the row's benchmarks did not run.
  std::optional<double> figureOf(const Row& row) const {
    const auto numerator = figures_.find(row.numerator), denominator = figures_.find(row.denominator);
    if (numerator == figures_.end()) return std::nullopt;
    if (row.denominator.empty()) return numerator->second;
    if (denominator == figures_.end()) return std::nullopt;
    return numerator->second / denominator->second;
  }

 private:
  void record(const Run& run) {
    // Other programs on the machine cost real time only. What runs on several threads must say UseRealTime().
    const bool isReal = !run.run_name.time_type.empty();
    const double time = isReal ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime();
    const std::string name = run.run_name.str();
    figures_[name] = 1000 * time / benchmark::GetTimeUnitMultiplier(run.time_unit);
    for (const auto& [counter, value] : run.counters) figures_[counterKey(name, counter)] = value;
  }

  std::map<std::string, double> figures_;
};

bool isMet(double value, const std::string& target) {
  const double limit = std::stod(target.substr(2));
  return target[0] == '<' ? value <= limit : value >= limit;
}

void printTable(const Recorder& recorder) {
  fmt::print("\n{:<46}{:>10}   {}\n", "Figure of this run", "value", "target");
  for (const Row& row : rows()) {
    const std::optional<double> figure = recorder.figureOf(row);
    const std::string value = figure ? fmt::format("{:.3f}", *figure) : "not run";
    const bool missed = figure && !isMet(*figure, row.target);
    fmt::print("{:<46}{:>10}   {}{}{}\n", row.name, value, row.target, row.unit, missed ? "   MISSED" : "");
  }
}

}  // namespace

bool ratio(std::string name, std::string numerator, std::string denominator, std::string target) {
  return addRow({std::move(name), std::move(numerator), std::move(denominator), "", std::move(target)});
}

bool milliseconds(std::string name, std::string benchmark, std::string target) {
  return addRow({std::move(name), std::move(benchmark), "", " ms", std::move(target)});
}

bool counter(std::string name, std::string benchmark, std::string counter, std::string target) {
  return addRow({std::move(name), counterKey(benchmark, counter), "", "", std::move(target)});
}

}  // namespace anamorph

int main(int argc, char** argv) {
  // What is compared takes turns, so that a machine that slows down meanwhile slows both. Arguments override.
  std::vector<std::string> arguments{argv[0], "--benchmark_repetitions=9", "--benchmark_min_time=0.1",
                                     "--benchmark_enable_random_interleaving=true",
                                     "--benchmark_display_aggregates_only=true"};
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 2;
  anamorph::Recorder recorder;
  benchmark::RunSpecifiedBenchmarks(&recorder);
  anamorph::printTable(recorder);
}
