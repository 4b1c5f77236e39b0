#include "level/file_remarks.h"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

namespace anamorph {
namespace {

constexpr std::size_t mostFaults = 100;  // that are told; who has more has another kind of file

}  // namespace

void FileRemarks::addFault(const std::string& message, const JsonPlace& place, const std::string& path) {
  faults_.push_back({place, Error(message, file_, whereText(place, path))});
}

void FileRemarks::addWarning(const std::string& message, const JsonPlace& place, const std::string& path) {
  warnings_.push_back({place, Error(message, file_, whereText(place, path))});
}

void FileRemarks::add(const FileRemarks& other) {
  faults_.insert(faults_.end(), other.faults_.begin(), other.faults_.end());
  warnings_.insert(warnings_.end(), other.warnings_.begin(), other.warnings_.end());
}

void FileRemarks::throwFaults() const {
  if (faults_.empty()) return;
  std::vector<Error> errors;
  for (const Remark& fault : inOrder(faults_)) errors.push_back(fault.error);
  if (errors.size() == 1) throw errors.front();
  if (errors.size() > mostFaults) {
    const std::size_t more = errors.size() - mostFaults;
    errors.erase(errors.begin() + mostFaults, errors.end());
    errors.emplace_back(fmt::format("{} more faults", more), file_);
  }
  throw Error(std::move(errors));
}

std::vector<std::string> FileRemarks::warnings() const {
  std::vector<std::string> texts;
  for (const Remark& warning : inOrder(warnings_)) texts.emplace_back(warning.error.what());
  return texts;
}

std::vector<FileRemarks::Remark> FileRemarks::inOrder(std::vector<Remark> remarks) {
  std::stable_sort(remarks.begin(), remarks.end(), [](const Remark& a, const Remark& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  return remarks;
}

}  // namespace anamorph
