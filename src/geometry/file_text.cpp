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

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<double> parseNumber(std::string_view word) {
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

std::string lineAt(std::string_view text, std::size_t offset) {
  const auto before = text.substr(0, offset);
  return fmt::format("line {}", 1 + std::count(before.begin(), before.end(), '\n'));
}

LineReader::LineReader(std::string_view text)
    : rest_(text), end_(text.find('\n') == std::string_view::npos ? '\r' : '\n') {
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

bool LineReader::next(std::string_view& line) {
  if (rest_.empty()) return false;
  number_ = linesTaken_ + 1;
  line = takePhysicalLine();
  if (!line.ends_with('\\')) return true;
  joined_.clear();
  while (line.ends_with('\\')) {
    joined_.append(line.substr(0, line.size() - 1)).push_back(' ');
    line = rest_.empty() ? std::string_view() : takePhysicalLine();
  }
  line = joined_.append(line);
  return true;
}

std::string_view LineReader::takePhysicalLine() {
  ++linesTaken_;
  const void* found = std::memchr(rest_.data(), end_, rest_.size());
  const std::size_t length =
      found ? static_cast<std::size_t>(static_cast<const char*>(found) - rest_.data()) : rest_.size();
  std::string_view line = rest_.substr(0, length);
  rest_.remove_prefix(found ? length + 1 : length);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace anamorph
