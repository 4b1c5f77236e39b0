// Faults of users and data. An Error says what happened, in which file and where in it, and reads
// `file: where: expected, got`, for example `levels/3.json: /mirror/radius: expected a number > 0, got -4`.
// It is caught only where somebody is told: in main, where one of many files is looked at, in a worker's job.
// A miss or a cancel is no fault: those are values.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace anamorph {

struct Error : std::runtime_error {
  /// `where` is a JSON path, a line, a vertex...; empty parts are left out of what().
  explicit Error(std::string message, std::string file = {}, std::string where = {});
  /// Several faults of one file, at least one, found at once. It reads as the first of them, and says how many more
  /// there are.
  explicit Error(std::vector<Error> found);

  std::string message;
  std::string file;
  std::string where;
  std::vector<Error> faults;  ///< all of them, where several were found at once
};

/// A line for each fault: what() of the error, or of all that were found at once.
std::vector<std::string> linesOf(const Error& error);

}  // namespace anamorph
