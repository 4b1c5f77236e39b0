#include "panels/number_breaks.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace anamorph {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool beginsNumber(std::string_view text) {
  const std::size_t sign = text.starts_with("-") ? 1 : 0;
  return text.size() > sign && isDigit(text[sign]);
}

bool beginsUnit(std::string_view text) {
  constexpr std::array<std::string_view, 5> units{"%", "mm", "cm", "px", "ms"};
  return std::any_of(units.begin(), units.end(), [&](std::string_view unit) {
    return text.starts_with(unit) && (text.size() == unit.size() || !isLetter(text[unit.size()]));
  });
}

// `before` and `after` the blank.
bool isWithinNumbers(std::string_view before, std::string_view after) {
  if (before.empty()) return false;
  const char last = before.back();
  if (isDigit(last)) return beginsUnit(after) || (after.starts_with("x ") && beginsNumber(after.substr(2)));
  if (!beginsNumber(after)) return false;
  if (last == 'x')
    return before.size() > 2 && before[before.size() - 2] == ' ' && isDigit(before[before.size() - 3]);
  const std::size_t open = before.find_last_of("()");
  return (last == ',' || last == ';') && open != std::string_view::npos && before[open] == '(';
}

}  // namespace

std::string numbersTogether(const std::string& text) {
  const std::string_view all = text;
  std::string together;
  together.reserve(text.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i] == ' ' && isWithinNumbers(all.substr(0, i), all.substr(i + 1))) {
      together += "\u00a0";
    } else {
      together += all[i];
    }
  }
  return together;
}

}  // namespace anamorph
