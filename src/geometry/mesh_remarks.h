// What a reader has to say about a mesh file: what it could not use and has left out, counted by kind, with the first
// place of each. A mesh that other programs open is opened; but nothing is lost without a word.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"

namespace anamorph {

/// A kind of remark, in the words of its warning: for one, and for more, with {} in the place of the number.
struct Remark {
  std::string_view one, many;
};

/// Where something is, and what is wrong with it in the words of an Error; empty when it is no fault.
struct RemarkPlace {
  std::string where, problem;
};

class MeshRemarks {
 public:
  /// `file` is the name for messages.
  explicit MeshRemarks(std::string file) : file_(std::move(file)) {}

  const std::string& file() const { return file_; }

  /// Counts one more of a kind, which must live as long. `place`, a callable that gives the RemarkPlace, is asked for
  /// the first one only, so that a million of them take no time.
  template <typename Place>
  void add(const Remark& kind, const Place& place) {
    Counted& counted = find(kind);
    if (counted.count++ == 0) setPlace(counted, place());
  }

  /// Whether there is one of this kind.
  bool has(const Remark& kind) const;

  /// A remark that there is only one of.
  void say(std::string where, std::string text);

  /// Whole sentences, `file: where: what`, in the order in which their kinds were first met.
  std::vector<std::string> warnings() const;

  /// The first fault, if there was any: why the file is refused when nothing of it is left.
  const std::optional<Error>& firstFault() const { return firstFault_; }

 private:
  struct Counted {
    const Remark* kind;  // null for what say() said
    std::size_t count;
    std::string where, text;
  };

  Counted& find(const Remark& kind);
  void setPlace(Counted& counted, RemarkPlace place);

  std::string file_;
  std::vector<Counted> counted_;
  std::optional<Error> firstFault_;
};

/// The Error of a file without a triangle: its first fault, else that there is none. `what` was found instead, for
/// example "a point cloud".
[[noreturn]] void failWithoutTriangles(const MeshRemarks& remarks, std::string_view what,
                                       std::size_t vertices);

}  // namespace anamorph
