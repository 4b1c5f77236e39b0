#include "geometry/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "geometry/file_text.h"

namespace anamorph {
namespace {

constexpr Remark unknownLines{"1 unknown line of the head skipped", "{} unknown lines of the head skipped"};

template <typename Value>
using NamedValues = std::vector<std::pair<std::string_view, Value>>;

template <typename Value>
std::optional<Value> findNamed(const NamedValues<Value>& values, std::string_view name) {
  const auto found =
      std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.first == name; });
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

std::optional<PlyType> findType(std::string_view name) {
  static const NamedValues<PlyType> types{
      {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
      {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
      {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
      {"float64", PlyType::float64}};
  return findNamed(types, name);
}

std::optional<PlyFormat> findFormat(std::string_view name) {
  static const NamedValues<PlyFormat> formats{{"ascii", PlyFormat::ascii},
                                              {"binary_little_endian", PlyFormat::binaryLittleEndian},
                                              {"binary_big_endian", PlyFormat::binaryBigEndian}};
  return findNamed(formats, name);
}

std::optional<std::uint64_t> parseCount(std::string_view word) {
  constexpr std::size_t mostDigits = 18;
  if (word.empty() || word.size() > mostDigits) return std::nullopt;
  std::uint64_t count = 0;
  for (const char c : word) {
    if (c < '0' || c > '9') return std::nullopt;
    count = 10 * count + static_cast<std::uint64_t>(c - '0');
  }
  return count;
}

class PlyHeaderReader {
 public:
  PlyHeaderReader(std::string_view bytes, MeshRemarks& remarks)
      : rest_(withoutByteOrderMark(bytes)), bytes_(bytes), remarks_(remarks) {}

  PlyHeader read() {
    while (line_.empty()) takeLine();
    if (line_ != "ply") fail("\"ply\"");
    takeLine();
    while (line_ != "end_header") {
      readLine();
      takeLine();
    }
    if (!formatKnown_) fail("a format line above");
    header_.size = bytes_.size() - rest_.size();
    return std::move(header_);
  }

 private:
  void readLine() {
    std::string_view rest = line_;
    const std::string_view keyword = takeWord(rest);
    if (keyword == "comment" || keyword == "obj_info" || keyword.empty()) return;
    if (keyword == "format") {
      readFormat(rest);
    } else if (keyword == "element") {
      readElement(rest);
    } else if (keyword == "property") {
      readProperty(rest);
    } else {
      remarks_.add(unknownLines, [&] { return RemarkPlace{where(), {}}; });
    }
  }

  void readFormat(std::string_view rest) {
    const auto format = findFormat(takeWord(rest));
    if (!format || takeWord(rest) != "1.0") fail("ascii, binary_little_endian or binary_big_endian, and 1.0");
    header_.format = *format;
    formatKnown_ = true;
  }

  void readElement(std::string_view rest) {
    const std::string name(takeWord(rest));
    const auto count = parseCount(takeWord(rest));
    if (!count) fail("the name of an element and how many there are");
    const auto same = [&](const PlyElement& element) { return element.name == name; };
    if (std::any_of(header_.elements.begin(), header_.elements.end(), same)) fail("each element once");
    header_.elements.push_back({name, *count, {}});
  }

  void readProperty(std::string_view rest) {
    if (header_.elements.empty()) fail("an element before its properties");
    PlyProperty property;
    std::string_view word = takeWord(rest);
    if (word == "list") {
      property.countType = findType(takeWord(rest));
      if (!property.countType) fail("a type after list");
      word = takeWord(rest);
    }
    const auto type = findType(word);
    property.name = takeWord(rest);
    if (!type || property.name.empty()) fail("the type and the name of a property");
    property.type = *type;
    header_.elements.back().properties.push_back(std::move(property));
  }

  // Where lines end in \r alone, a \n behind end_header is a byte of the data.
  void takeLine() {
    if (rest_.empty()) {
      throw Error("expected end_header, got the end of the file", remarks_.file(), where());
    }
    ++number_;
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    line_ = trimmed(rest_.substr(0, end));
    const bool isPair = rest_.substr(end, 2) == "\r\n";
    if (number_ == 1) returnsAlone_ = end < rest_.size() && rest_[end] == '\r' && !isPair;
    rest_.remove_prefix(std::min(end + (isPair && !returnsAlone_ ? 2 : 1), rest_.size()));
  }

  std::string where() const { return fmt::format("line {}", number_); }

  [[noreturn]] void fail(std::string_view expected) const {
    throw Error(fmt::format("expected {}, got {}", expected, inQuotes(line_)), remarks_.file(), where());
  }

  std::string_view rest_, line_;
  std::string_view bytes_;
  MeshRemarks& remarks_;
  std::size_t number_ = 0;     // of the line
  bool returnsAlone_ = false;  // lines end in \r
  PlyHeader header_;
  bool formatKnown_ = false;
};

}  // namespace

std::size_t sizeOf(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      break;
  }
  return 8;
}

PlyHeader readPlyHeader(std::string_view bytes, MeshRemarks& remarks) {
  return PlyHeaderReader(bytes, remarks).read();
}

}  // namespace anamorph
