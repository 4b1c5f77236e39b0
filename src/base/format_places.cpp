#include "base/format_places.h"

#include <charconv>

namespace anamorph {
namespace {

// "{12:.3f}" without its braces. Nothing when the part before the colon is neither empty nor a number.
struct Place {
  std::optional<std::size_t> number;
  std::string spec;
};

std::optional<Place> parsePlace(std::string_view inside) {
  const std::size_t colon = inside.find(':');
  const std::string_view name = inside.substr(0, colon);
  Place place;
  if (colon != std::string_view::npos) place.spec = inside.substr(colon + 1);
  if (name.empty()) return place;
  std::size_t number = 0;
  const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
  if (read.ec != std::errc() || read.ptr != name.data() + name.size()) return std::nullopt;
  place.number = number;
  return place;
}

}  // namespace

std::optional<FormatPlaces> findFormatPlaces(std::string_view text) {
  FormatPlaces places;
  std::size_t counted = 0;
  bool numbered = false;
  while (true) {
    const std::size_t brace = text.find_first_of("{}");
    if (brace == std::string_view::npos) return places;
    text.remove_prefix(brace);
    if (text.size() > 1 && text[0] == text[1]) {
      text.remove_prefix(2);
      continue;
    }
    const std::size_t end = text.find_first_of("{}", 1);
    if (text[0] == '}' || end == std::string_view::npos || text[end] == '{') return std::nullopt;
    const auto place = parsePlace(text.substr(1, end - 1));
    if (!place) return std::nullopt;
    numbered |= place->number.has_value();
    if (numbered && (counted > 0 || !place->number)) return std::nullopt;
    places.emplace(numbered ? *place->number : counted++, place->spec);
    text.remove_prefix(end + 1);
  }
}

bool takesSameValues(std::string_view english, std::string_view translation) {
  const auto places = findFormatPlaces(english);
  return !places || findFormatPlaces(translation) == places;
}

}  // namespace anamorph
