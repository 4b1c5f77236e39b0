// The closing table of the benchmark program: quotients of two times of the same run, and times, each with
// its target. One line a row, beside the benchmarks it speaks of:
//
//   const bool rows[] = {
//       ratio("deform sphere / memcpy", "deform/sphere", "memcpy", "<= 3.0"),
//       milliseconds("live step", "live", "<= 8.0"),
//       counter("rays as fast as Embree", "rays/primary", "of Embree", ">= 0.75"),
//   };
//
// Benchmarks are named as Google Benchmark prints them, targets are "<= x" or ">= x". All return true.
#pragma once

#include <string>

namespace anamorph {

/// time(numerator) / time(denominator).
bool ratio(std::string name, std::string numerator, std::string denominator, std::string target);

/// The time of one iteration, in milliseconds.
bool milliseconds(std::string name, std::string benchmark, std::string target);

/// What the benchmark itself counted.
bool counter(std::string name, std::string benchmark, std::string counter, std::string target);

}  // namespace anamorph
