#include "level/languages.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/file.h"
#include "base/format_places.h"
#include "base/resources.h"
#include "level/json.h"
#include "level/limits.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostNameBytes = 200;

fs::path languageFolder() {
  return resourceFolder() / "assets" / "languages";
}

const JsonValue& member(const JsonValue& object, const char* key, JsonValue::Kind kind, const char* kindName,
                        const std::string& file) {
  const JsonValue* value = findMember(object, key);
  if (value && value->kind == kind) return *value;
  throw Error(std::string("expected ") + kindName + ", got " + (value ? describeJson(*value) : "nothing"),
              file, joinJsonPath("", key));
}

std::string bytesText(std::size_t most, const std::string& got) {
  return fmt::format("expected at most {} bytes, got {}", most, got.size());
}

void checkText(const std::string& english, const JsonValue& text, const std::string& file) {
  const auto fail = [&](const std::string& what) {
    throw Error(what, file, joinJsonPath("/texts", english));
  };
  if (text.kind != JsonValue::Kind::string || text.text.empty()) {
    fail("expected a string that is not empty, got " + describeJson(text));
  }
  if (text.text.size() > limits::mostTextBytes) fail(bytesText(limits::mostTextBytes, text.text));
  if (!takesSameValues(english, text.text)) {
    fail("expected the same {} places as in English, got " + describeJson(text));
  }
}

std::string systemLanguage() {
  for (const char* variable : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    const char* value = std::getenv(variable);
    if (value && *value) return std::string(value).substr(0, std::string(value).find_first_of("_.@"));
  }
  return "en";
}

// A language's file, read once.
struct KeptLanguage {
  std::string name;
  TextTable texts;
};

// Kept for ever, as setLanguage() wants it.
const KeptLanguage& keptLanguage(const std::string& code) {
  static std::map<std::string, KeptLanguage> kept;
  if (const auto found = kept.find(code); found != kept.end()) return found->second;
  KeptLanguage language;
  language.texts = loadTexts(languageFolder() / (code + ".json"), &language.name);
  return kept[code] = std::move(language);
}

}  // namespace

TextTable parseTexts(std::string_view text, const std::string& file, std::string* name) {
  const JsonValue json = parseJson(text, file);
  using Kind = JsonValue::Kind;
  const JsonValue& format = member(json, "format", Kind::string, "\"anamorph-language\"", file);
  if (format.text != "anamorph-language") {
    throw Error("expected \"anamorph-language\", got " + describeJson(format), file, "/format");
  }
  if (name) {
    *name = member(json, "name", Kind::string, "a string", file).text;
    if (name->size() > mostNameBytes) throw Error(bytesText(mostNameBytes, *name), file, "/name");
  }
  const JsonValue& texts = member(json, "texts", Kind::object, "an object", file);
  TextTable table;
  for (std::size_t i = 0; i < texts.keys.size(); ++i) {
    checkText(texts.keys[i], texts.items[i], file);
    table[texts.keys[i]] = texts.items[i].text;
  }
  return table;
}

TextTable loadTexts(const fs::path& file, std::string* name) {
  return parseTexts(readFile(file, std::size_t{4} << 20).view(), file.string(), name);
}

std::vector<LanguageChoice> listLanguages() {
  std::vector<LanguageChoice> languages;
  std::error_code problem;
  for (fs::directory_iterator entry(languageFolder(), problem), end; !problem && entry != end;
       entry.increment(problem)) {
    if (entry->path().extension() != ".json") continue;
    try {
      const std::string code = entry->path().stem().string();
      languages.push_back({code, keptLanguage(code).name});
    } catch (const Error&) {
      // A broken file costs its own language only; choosing it says what is wrong.
    }
  }
  std::sort(languages.begin(), languages.end(),
            [](const LanguageChoice& a, const LanguageChoice& b) { return a.code < b.code; });
  languages.insert(languages.begin(), {"en", "English"});
  return languages;
}

const TextTable* chooseLanguage(const std::string& code) {
  std::string wanted = code;
  if (code.empty()) {
    wanted = systemLanguage();
    std::error_code ignored;
    if (!fs::exists(languageFolder() / (wanted + ".json"), ignored)) wanted = "en";
  }
  const TextTable* texts = wanted == "en" ? nullptr : &keptLanguage(wanted).texts;
  setLanguage(texts);
  return texts;
}

}  // namespace anamorph
