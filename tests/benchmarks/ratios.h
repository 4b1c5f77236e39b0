// The closing table of the benchmark program: quotients of two times of the same run, and times, each with
// its target. One line a row, beside the benchmarks it speaks of:
//
//   const bool rows[] = {
//       ratio("deform sphere / memcpy", "deform/sphere", "memcpy", "<= 3.0"),
//       milliseconds("live step", "live", "<= 8.0"),
//   };
#pragma once

#include <string>

namespace anamorph {

/// time(numerator) / time(denominator), both named as Google Benchmark prints them. `target` is "<= x" or ">=
/// x". Returns true.
bool ratio(std::string name, std::string numerator, std::string denominator, std::string target);

/// The time of one iteration, in milliseconds.
bool milliseconds(std::string name, std::string benchmark, std::string target);

}  // namespace anamorph
