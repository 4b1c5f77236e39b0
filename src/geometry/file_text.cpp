#include "geometry/file_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace anamorph {
namespace {

// For what from_chars cannot say (is 1e-400 too small or too large?) and for libraries without it.
std::optional<double> parseNumberSlowly(std::string_view word) {
  if (word.empty() || word.find_first_not_of("0123456789+-.eE") != std::string_view::npos)
    return std::nullopt;
  const std::string terminated(word);
  char* end = nullptr;
  const double value = std::strtod(terminated.c_str(), &end);
  if (end != terminated.c_str() + terminated.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// A number as C writes it.
std::optional<double> parseCNumber(std::string_view word) {
#ifdef __cpp_lib_to_chars
  std::string_view digits = word;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
  double value = 0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (failure == std::errc() && end == digits.data() + digits.size()) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  }
  if (failure != std::errc::result_out_of_range) return std::nullopt;
#endif
  return parseNumberSlowly(word);
}

char smallLetter(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// Whether a \r stands where no \n follows.
bool hasLoneReturn(std::string_view text) {
  for (std::size_t at = text.find('\r'); at != std::string_view::npos; at = text.find('\r', at + 1)) {
    if (at + 1 < text.size() && text[at + 1] != '\n') return true;
  }
  return false;
}

bool isLetter(char c) {
  return smallLetter(c) >= 'a' && smallLetter(c) <= 'z';
}

}  // namespace

std::string_view takeWord(std::string_view& text) {
  const char* p = text.data();
  const char* const end = p + text.size();
  while (p != end && isBlank(*p)) ++p;
  const char* const begin = p;
  while (p != end && !isBlank(*p)) ++p;
  text.remove_prefix(static_cast<std::size_t>(p - text.data()));
  return {begin, static_cast<std::size_t>(p - begin)};
}

std::string_view takeWordPastComments(std::string_view& text) {
  std::string_view word = takeWord(text);
  while (!word.empty() && word[0] == '#') {
    text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
    word = takeWord(text);
  }
  return word;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

bool isKeyword(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                    [](char a, char b) { return smallLetter(a) == b; });
}

std::string_view withoutByteOrderMark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.substr(text.starts_with(mark) ? mark.size() : 0);
}

std::string_view withoutPadding(std::string_view text) {
  text = withoutByteOrderMark(text);
  constexpr char controlZ = 0x1A;
  while (!text.empty() && (isBlank(text.back()) || text.back() == '\0' || text.back() == controlZ))
    text.remove_suffix(1);
  return text;
}

bool isPadding(std::string_view text) {
  return withoutPadding(text).empty();
}

std::optional<double> parseNumber(std::string_view word) {
  if (const auto number = parseCNumber(word)) return number;
  if (word.find_first_of("dD") == std::string_view::npos) return std::nullopt;
  std::string withE(word);
  std::replace_if(
      withE.begin(), withE.end(), [](char c) { return c == 'd' || c == 'D'; }, 'e');
  return parseCNumber(withE);
}

std::optional<double> parseCoordinate(std::string_view word) {
  const std::optional<double> number = parseNumber(word);
  return number && std::abs(*number) <= maxCoordinate ? number : std::nullopt;
}

bool areCoordinates(const Point& p) {
  // Written so that a NaN fails.
  return std::abs(p.x) <= maxCoordinate && std::abs(p.y) <= maxCoordinate && std::abs(p.z) <= maxCoordinate;
}

std::string inQuotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result = "\"";
  for (const char c : text.substr(0, longest)) {
    if (c >= ' ' && c <= '~') {
      result += c;
    } else {
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    }
  }
  return result + (text.size() > longest ? "...\"" : "\"");
}

std::string inQuotesOrEnd(std::string_view text) {
  return text.empty() ? "the end of the file" : inQuotes(text);
}

std::string decimalCommaHint(std::string_view text) {
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    if (text[i] == ',' && isDigit(text[i - 1]) && isDigit(text[i + 1]))
      return ": a decimal comma is not read, write numbers with a point";
  }
  return {};
}

std::string lineAt(std::string_view text, std::size_t offset) {
  const auto before = text.substr(0, offset);
  const char end = text.find('\n') == std::string_view::npos ? '\r' : '\n';
  return fmt::format("line {}", 1 + std::count(before.begin(), before.end(), end));
}

LineReader::LineReader(std::string_view text) : rest_(withoutPadding(text)) {
  if (rest_.find('\n') == std::string_view::npos) {
    end_ = '\r';
  } else {
    returnEndsToo_ = hasLoneReturn(rest_);
  }
}

bool LineReader::next(std::string_view& line) {
  if (rest_.empty()) return false;
  number_ = linesTaken_ + 1;
  line = takePhysicalLine();
  return true;
}

std::string_view LineReader::continued(std::string_view line) {
  const auto isContinued = [](std::string_view text) {
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text.ends_with('\\');
  };
  if (!isContinued(line)) return line;
  joined_.clear();
  while (isContinued(line)) {
    joined_.append(line.substr(0, line.rfind('\\'))).push_back(' ');
    const std::string_view ahead = trimmed(rest_.substr(0, 100));
    line = ahead.empty() || isLetter(ahead[0]) ? std::string_view() : takePhysicalLine();
  }
  return joined_.append(line);
}

std::string_view LineReader::takePhysicalLine() {
  ++linesTaken_;
  std::size_t length = 0;
  if (returnEndsToo_) {
    length = std::min(rest_.find_first_of("\r\n"), rest_.size());
  } else {
    const void* found = std::memchr(rest_.data(), end_, rest_.size());
    length = found ? static_cast<std::size_t>(static_cast<const char*>(found) - rest_.data()) : rest_.size();
  }
  std::string_view line = rest_.substr(0, length);
  const bool isPair = returnEndsToo_ && rest_.substr(length, 2) == "\r\n";
  rest_.remove_prefix(std::min(length + (isPair ? 2 : 1), rest_.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace anamorph
