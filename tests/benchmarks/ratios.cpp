#include "ratios.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdio>
#include <map>
#include <vector>

namespace anamorph {
namespace {

struct Row {
  std::string name;
  std::string numerator;
  std::string denominator;  // empty: the numerator's milliseconds
  std::string target;
};

std::vector<Row>& rows() {
  static std::vector<Row> all;  // registered before main
  return all;
}

/// Prints as usual and keeps the seconds of an iteration; of several repetitions the median.
class Recorder : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      const bool single = run.run_type == Run::RT_Iteration && run.repetitions <= 1;
      const bool median = run.run_type == Run::RT_Aggregate && run.aggregate_name == "median";
      if (run.error_occurred || !(single || median)) continue;
      const double perSecond = benchmark::GetTimeUnitMultiplier(run.time_unit);
      seconds_[run.run_name.str()] = run.GetAdjustedRealTime() / perSecond;
    }
  }

  /// The row's figure; negative when one of its benchmarks did not run.
  double valueOf(const Row& row) const {
    const auto numerator = seconds_.find(row.numerator), denominator = seconds_.find(row.denominator);
    if (numerator == seconds_.end()) return -1;
    if (row.denominator.empty()) return numerator->second * 1000;
    return denominator == seconds_.end() ? -1 : numerator->second / denominator->second;
  }

 private:
  std::map<std::string, double> seconds_;
};

bool isMet(double value, const std::string& target) {
  const double limit = std::stod(target.substr(2));
  return target[0] == '<' ? value <= limit : value >= limit;
}

void printTable(const Recorder& recorder) {
  fmt::print("\n{:<46}{:>10}   {}\n", "Figure of this run", "value", "target");
  for (const Row& row : rows()) {
    const double value = recorder.valueOf(row);
    if (value < 0) {
      fmt::print("{:<46}{:>10}   {}\n", row.name, "not run", row.target);
      continue;
    }
    const char* unit = row.denominator.empty() ? " ms" : "";
    fmt::print("{:<46}{:>10.3f}   {}{}{}\n", row.name, value, row.target, unit,
               isMet(value, row.target) ? "" : "   MISSED");
  }
}

}  // namespace

bool ratio(std::string name, std::string numerator, std::string denominator, std::string target) {
  rows().push_back({std::move(name), std::move(numerator), std::move(denominator), std::move(target)});
  return true;
}

bool milliseconds(std::string name, std::string benchmark, std::string target) {
  return ratio(std::move(name), std::move(benchmark), {}, std::move(target));
}

}  // namespace anamorph

int main(int argc, char** argv) {
  // What is compared takes turns, so that a machine that slows down meanwhile slows both. Arguments override.
  std::vector<std::string> arguments{argv[0], "--benchmark_repetitions=5", "--benchmark_min_time=0.1",
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
