// Where the values of a JSON text begin. The library tells what it reads, not where; but it tells in the order of the
// text, one token after the other, so following it through the text is enough.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace anamorph {

/// Where something begins in its file: line and column from 1 on, columns in characters; 0 where nothing was read.
struct JsonPlace {
  int line = 0, column = 0;

  /// Where it was read makes no value another one.
  bool operator==(const JsonPlace&) const { return true; }
};

class JsonPlaces {
 public:
  explicit JsonPlaces(std::string_view text) : text_(text) {}

  /// Where the next token begins: a brace, a bracket, a string, a number or a word. Goes on to its end.
  JsonPlace next();

 private:
  void step();

  std::string_view text_;
  std::size_t at_ = 0;
  JsonPlace here_{1, 1};
};

/// Of the byte at `offset`.
JsonPlace placeOfByte(std::string_view text, std::size_t offset);

/// "line 7, column 31: /optic/shape/radius", what there is of it: nothing was read at line 0.
std::string whereText(const JsonPlace& place, const std::string& path);

}  // namespace anamorph
