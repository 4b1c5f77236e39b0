// The values of a PLY file, row by row, whatever its format. All of them fit a double exactly.
//
// Rows of a text file are lines: what a line has too much is passed over, what it lacks is missing. Some files, though,
// spread a row over several lines or put several on one. A file of fewer lines than rows is of the second kind, and
// lines that are too many may continue rows that are too short.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/ply_header.h"

namespace anamorph {

class PlyValues {
 public:
  /// `data` is what follows the head.
  PlyValues(std::string_view data, const PlyHeader& header);

  /// The next value of the row; nothing when it is not a number or there is none. lastWord() then says what was there.
  std::optional<double> next(PlyType type);

  /// Passes over `count` values; false when there are fewer.
  bool skip(PlyType type, std::size_t count);

  /// Goes to the next row. False when there were more values in this one.
  bool endRow();

  /// Whether nothing is left, of this row or others.
  bool atEnd() const { return rest_.empty(); }

  bool isText() const { return format_ == PlyFormat::ascii; }

  /// Whether a row without a value that it should have may be complete all the same.
  bool rowsMayBeShort() const { return rowsAreLines_; }

  /// How many rows of the element the rest could hold at the very most.
  std::size_t mostRows(const PlyElement& element) const;

  /// What next() found in a text file; empty at the end of a row.
  std::string_view lastWord() const { return word_; }

  /// What is left when all rows are read: "3 lines", "4 bytes"; empty when nothing is.
  std::string leftOver() const;

 private:
  std::optional<double> nextBinary(PlyType type);
  std::string_view takeWordOfRow();
  std::uint64_t countLines() const;
  void skipBlanks();
  bool skipLineEnds();

  std::string_view rest_;
  PlyFormat format_;
  std::string_view word_;  // of a text file, the last one
  char lineEnd_ = '\n';
  bool rowsAreLines_ = false;
  std::uint64_t spareLines_ = 0;  // which may continue rows
};

}  // namespace anamorph
