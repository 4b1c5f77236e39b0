// Reading text that nobody vouches for: words, lines and numbers of the mesh files. Numbers are correctly
// rounded, so what the program wrote reads back to the identical double. Nothing here depends on the locale.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "math/vec.h"

namespace anamorph {

/// Coordinates beyond this are taken for damage.
constexpr double maxCoordinate = 1e9;

inline bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

/// Takes the first word off `text`; empty when there is none.
std::string_view takeWord(std::string_view& text);

/// The same, but past lines of comment: those that begin with #.
std::string_view takeWordPastComments(std::string_view& text);

/// `text` without blanks at its ends.
std::string_view trimmed(std::string_view text);

/// Whether the two are the same word when capitals count as small letters.
bool isKeyword(std::string_view word, std::string_view keyword);

/// `text` without the mark that some programs put in front of UTF-8.
std::string_view withoutByteOrderMark(std::string_view text);

/// A file's text without the byte order mark in front and the padding behind: blanks, 0 bytes and the Ctrl-Z of old
/// systems.
std::string_view withoutPadding(std::string_view text);

/// Whether withoutPadding() leaves nothing.
bool isPadding(std::string_view text);

/// The decimal number that `word` is, also with the D of Fortran for the E; nothing when it is anything else, such
/// as "nan", or not a finite double.
std::optional<double> parseNumber(std::string_view word);

/// The number that `word` is when it may be a coordinate: finite and at most maxCoordinate.
std::optional<double> parseCoordinate(std::string_view word);

/// Whether all three may be coordinates.
bool areCoordinates(const Point& p);

/// What parseCoordinate accepts, in the words of the messages.
inline constexpr std::string_view threeCoordinates = "three numbers of magnitude at most 1e9";

/// `text` in quotes for a message: shortened, and with bytes outside ASCII's letters and signs written as
/// \xNN.
std::string inQuotes(std::string_view text);

/// inQuotes(), or the words "the end of the file" when there is no text left.
std::string inQuotesOrEnd(std::string_view text);

/// What to say about a text that was expected to be numbers: empty when it has no decimal comma.
std::string decimalCommaHint(std::string_view text);

/// "line N" for an offset into a text, N counted from 1.
std::string lineAt(std::string_view text, std::size_t offset);

/// The lines of a text, one after the other, without padding. They end in \n, \r\n or \r, also mixed.
class LineReader {
 public:
  explicit LineReader(std::string_view text);

  /// The next line without its end, valid until the next call. False after the last one.
  bool next(std::string_view& line);

  /// The line that next() gave, and those that a \ at its end continues it on. One that begins with a letter is
  /// no continuation.
  std::string_view continued(std::string_view line);

  /// Where the last line began, counted from 1.
  std::size_t number() const { return number_; }

 private:
  std::string_view takePhysicalLine();

  std::string_view rest_;
  char end_ = '\n';
  bool returnEndsToo_ = false;
  std::size_t number_ = 0;      // of the line that next() gave
  std::size_t linesTaken_ = 0;  // more than number_ when lines were joined
  std::string joined_;
};

}  // namespace anamorph
