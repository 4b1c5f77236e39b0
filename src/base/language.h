// The language of everything that people read in the window: one table from the English text, which stands
// in the code and in the levels, to the same text in the chosen language. A language is a file of its own
// (assets/languages, read by app/languages.h) and needs no code.
//
//   tr("Save")  -->  "Opslaan"      what a table does not have stays English
//
// Command line, log and the errors of files stay English: they are searched for and sent to us.
#pragma once

#include <map>
#include <string>

namespace anamorph {

using TextTable = std::map<std::string, std::string, std::less<>>;

/// From now on tr() answers from `table`, which has to live to the end of the program: texts that were handed
/// out stay valid. Null: English, as in the beginning. Other threads may call tr() meanwhile.
void setLanguage(const TextTable* table);

/// The text in the chosen language; valid at least as long as `english` is.
const char* tr(const char* english);
std::string tr(const std::string& english);

}  // namespace anamorph
