// Faults of users and data. An Error says what happened, in which file and where in it, and reads
// `file: where: expected, got`, for example `levels/3.json: /mirror/radius: expected a number > 0, got -4`.
// It is caught only where somebody is told: in main, where one of many files is looked at, in a worker's job.
// A miss or a cancel is no fault: those are values.
#pragma once

#include <stdexcept>
#include <string>

namespace anamorph {

struct Error : std::runtime_error {
  /// `where` is a JSON path, a line, a vertex...; empty parts are left out of what().
  explicit Error(std::string message, std::string file = {}, std::string where = {});

  std::string message;
  std::string file;
  std::string where;
};

}  // namespace anamorph
