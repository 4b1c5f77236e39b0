// The values of a PLY file, one after the other, whatever its format. All of them fit a double exactly.
#pragma once

#include <optional>
#include <string_view>

#include "geometry/ply_header.h"

namespace anamorph {

class PlyValues {
 public:
  /// `data` is what follows the head.
  PlyValues(std::string_view data, PlyFormat format) : rest_(data), format_(format) {}

  /// The next value; nothing when it is not a number or the data has ended. lastValue() then says what was
  /// there.
  std::optional<double> next(PlyType type);

  /// Passes over `count` values; false when there are fewer.
  bool skip(PlyType type, std::size_t count);

  /// How many rows of the element the rest could hold at the very most.
  std::size_t mostRows(const PlyElement& element) const;

  /// What next() found, for messages.
  std::string lastValue() const;

 private:
  std::optional<double> nextBinary(PlyType type);

  std::string_view rest_;
  PlyFormat format_;
  std::string_view word_;  // of a text file, the last one
};

}  // namespace anamorph
