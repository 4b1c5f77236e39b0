#include "level/json_places.h"

#include <algorithm>

#include <fmt/format.h>

namespace anamorph {
namespace {

constexpr std::string_view between = " \t\r\n,:", closing = "]}";

void pass(JsonPlace& place, char c) {
  if (c == '\n') {
    place = {place.line + 1, 1};
  } else if ((static_cast<unsigned char>(c) & 0xc0) != 0x80) {  // further bytes of a character take no column
    ++place.column;
  }
}

}  // namespace

JsonPlace JsonPlaces::next() {
  const auto more = [&] { return at_ < text_.size(); };
  const auto isOneOf = [&](std::string_view set) { return set.find(text_[at_]) != std::string_view::npos; };
  while (more() && isOneOf(between)) step();
  const JsonPlace begin = here_;
  if (!more()) return begin;
  const char first = text_[at_];
  step();
  if (first == '"') {
    for (bool escaped = false, open = true; more() && open;) {
      open = escaped || text_[at_] != '"';
      escaped = !escaped && text_[at_] == '\\';
      step();
    }
  } else if (first != '{' && first != '[' && closing.find(first) == std::string_view::npos) {
    while (more() && !isOneOf(between) && !isOneOf(closing)) step();
  }
  return begin;
}

void JsonPlaces::step() {
  pass(here_, text_[at_++]);
}

JsonPlace placeOfByte(std::string_view text, std::size_t offset) {
  JsonPlace place{1, 1};
  for (const char c : text.substr(0, std::min(offset, text.size()))) pass(place, c);
  return place;
}

std::string whereText(const JsonPlace& place, const std::string& path) {
  if (place.line == 0) return path;
  return fmt::format("line {}, column {}{}{}", place.line, place.column, path.empty() ? "" : ": ", path);
}

}  // namespace anamorph
