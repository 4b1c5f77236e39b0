// What is found while a file is read: faults, for which it is refused, and warnings. All of them are told, in the order
// of the file, each with its line and column.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "level/json_places.h"

namespace anamorph {

class FileRemarks {
 public:
  explicit FileRemarks(std::string file) : file_(std::move(file)) {}

  const std::string& file() const { return file_; }
  /// How many there are of both.
  std::size_t count() const { return faults_.size() + warnings_.size(); }

  void addFault(const std::string& message, const JsonPlace& place, const std::string& path);
  void addWarning(const std::string& message, const JsonPlace& place, const std::string& path);
  /// Takes over what was found by another reader of the file.
  void add(const FileRemarks& other);

  /// Throws Error with all faults; nothing when there are none.
  void throwFaults() const;
  /// Whole sentences.
  std::vector<std::string> warnings() const;

 private:
  struct Remark {
    JsonPlace place;
    Error error;
  };

  static std::vector<Remark> inOrder(std::vector<Remark> remarks);

  std::string file_;
  std::vector<Remark> faults_, warnings_;
};

}  // namespace anamorph
