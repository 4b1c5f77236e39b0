// The languages that are installed: one JSON file each in assets/languages, with the English text of
// everything that is shown and what it is in that language. A new language is one more file.
//
//   {"format": "anamorph-language", "version": 1, "name": "Nederlands", "texts": {"Save": "Opslaan", ...}}
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/language.h"

namespace anamorph {

/// A language that can be chosen: its code ("nl"), and what its speakers call it.
struct LanguageChoice {
  std::string code, name;
};

/// Throws Error `file: where: expected, got`; also for a translation that takes other values than its English
/// (base/format_places.h). `file` is only for messages.
TextTable parseTexts(std::string_view text, const std::string& file, std::string* name = nullptr);

/// parseTexts of a file of at most 4 MiB.
TextTable loadTexts(const std::filesystem::path& file, std::string* name = nullptr);

/// English first, then the files of the folder by name, which is their code; those that cannot be read are
/// left out.
std::vector<LanguageChoice> listLanguages();

/// Switches everything to a language; an unknown or broken one is an Error and changes nothing. "": as the
/// system is set ($LC_ALL, $LC_MESSAGES, $LANG), English when that is not installed.
/// Returns its texts; null for English.
const TextTable* chooseLanguage(const std::string& code);

}  // namespace anamorph
