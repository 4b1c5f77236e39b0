// The language of everything that people read in the window: one table from the English text, which stands
// in the code and in the levels, to the same text in the chosen language. A language is a file of its own
// (assets/languages, read by level/languages.h) and needs no code.
//
//   tr("Save")  -->  "Opslaan"                      what a table does not have stays English
//   trFormat("Saved: {}", file)                     the same with values in it
//   shownFormat("{:.2f} px", 0.25)  -->  "0,25 px"  values between which there are no words
//
// Numbers in these texts are written as people write them: with the language's decimal sign (its translation of "0.5"
// tells which), without exponents, and nothing is never "-0.00".
//
// Command line, log and the errors of files stay English: they are searched for and sent to us.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>

namespace anamorph {

using TextTable = std::map<std::string, std::string, std::less<>>;

/// From now on tr() answers from `table`, which has to live to the end of the program: texts that were handed
/// out stay valid. Null: English, as in the beginning. Other threads may call tr() meanwhile.
void setLanguage(const TextTable* table);

/// The text in the chosen language; valid at least as long as `english` is.
const char* tr(const char* english);
std::string tr(const std::string& english);

/// A number as people read it: "1000000" for what fmt writes as "1e+06", "0.00" for "-0.00", "0,5" in Dutch. `spec` is
/// what stands after the colon of fmt's place.
std::string shownNumber(double value, std::string_view spec);

/// A value of a text that people read: shownNumber() of the place that it is put into.
struct ShownNumber {
  double value;
};

/// Numbers with a fraction as ShownNumber, all other values as they are.
template <typename Value>
decltype(auto) shownValue(const Value& value) {
  if constexpr (std::is_floating_point_v<Value>) {
    return ShownNumber{static_cast<double>(value)};
  } else {
    return static_cast<const Value&>(value);
  }
}

/// What trFormat() does; `english` fits the arguments.
std::string formatTranslated(fmt::string_view english, fmt::format_args arguments);

template <typename... Shown>
std::string formatShown(fmt::string_view english, const Shown&... values) {
  return formatTranslated(english, fmt::make_format_args(values...));
}

/// The text in the chosen language with values in its {} places: trFormat("{} of {}", i, n). The compiler checks the
/// English one (fmt::runtime("...") where it cannot); where a translation does not fit the values, it is shown instead.
template <typename... Values>
std::string trFormat(fmt::format_string<Values...> english, Values&&... values) {
  return formatShown(english, shownValue(values)...);
}

/// The same for a text without words, which needs no translation: shownFormat("({:.2f}, {:.2f})", x, y).
template <typename... Values>
std::string shownFormat(fmt::format_string<Values...> text, Values&&... values) {
  return formatShown(text, shownValue(values)...);
}

}  // namespace anamorph

template <>
struct fmt::formatter<anamorph::ShownNumber> {
  constexpr auto parse(fmt::format_parse_context& context) {
    const auto end = std::find(context.begin(), context.end(), '}');
    spec = std::string_view(context.begin(), static_cast<std::size_t>(end - context.begin()));
    return end;
  }
  template <typename Context>
  auto format(const anamorph::ShownNumber& number, Context& context) const {
    const std::string text = anamorph::shownNumber(number.value, spec);
    return std::copy(text.begin(), text.end(), context.out());
  }

  std::string_view spec;
};
