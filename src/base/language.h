// The language of everything that people read in the window: one table from the English text, which stands
// in the code and in the levels, to the same text in the chosen language. A language is a file of its own
// (assets/languages, read by level/languages.h) and needs no code.
//
//   tr("Save")  -->  "Opslaan"      what a table does not have stays English
//   trFormat("Saved: {}", file)     the same with values in it
//
// Command line, log and the errors of files stay English: they are searched for and sent to us.
#pragma once

#include <map>
#include <string>

#include <fmt/format.h>

namespace anamorph {

using TextTable = std::map<std::string, std::string, std::less<>>;

/// From now on tr() answers from `table`, which has to live to the end of the program: texts that were handed
/// out stay valid. Null: English, as in the beginning. Other threads may call tr() meanwhile.
void setLanguage(const TextTable* table);

/// The text in the chosen language; valid at least as long as `english` is.
const char* tr(const char* english);
std::string tr(const std::string& english);

/// What trFormat() does; `english` fits the arguments.
std::string formatTranslated(fmt::string_view english, fmt::format_args arguments);

/// The text in the chosen language with values in its {} places: trFormat("{} of {}", i, n). The compiler checks the
/// English one (fmt::runtime("...") where it cannot); where a translation does not fit the values, it is shown instead.
template <typename... Values>
std::string trFormat(fmt::format_string<Values...> english, Values&&... values) {
  return formatTranslated(english, fmt::make_format_args(values...));
}

}  // namespace anamorph
