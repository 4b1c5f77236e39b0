#include "app/languages.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "base/resources.h"
#include "level/json.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

fs::path languageFolder() {
  return resourceFolder() / "assets" / "languages";
}

const JsonValue& member(const JsonValue& object, const char* key, JsonValue::Kind kind, const char* kindName,
                        const fs::path& file) {
  const JsonValue* value = findMember(object, key);
  if (value && value->kind == kind) return *value;
  throw Error(std::string("expected ") + kindName + ", got " + (value ? describeJson(*value) : "nothing"),
              file.string(), joinJsonPath("", key));
}

// The places that values are put into: "{} of {:.1f}" has two. In order, because values are.
std::vector<std::string> placesOf(const std::string& text) {
  std::vector<std::string> places;
  for (std::size_t begin = text.find('{'); begin != std::string::npos; begin = text.find('{', begin + 1)) {
    const std::size_t end = text.find('}', begin);
    if (end == std::string::npos) break;
    places.push_back(text.substr(begin, end - begin));
  }
  return places;
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

TextTable loadTexts(const fs::path& file, std::string* name) {
  const JsonValue json = parseJson(readFile(file, std::size_t{4} << 20).view(), file.string());
  using Kind = JsonValue::Kind;
  const JsonValue& format = member(json, "format", Kind::string, "\"anamorph-language\"", file);
  if (format.text != "anamorph-language") {
    throw Error("expected \"anamorph-language\", got " + describeJson(format), file.string(), "/format");
  }
  if (name) *name = member(json, "name", Kind::string, "a string", file).text;
  const JsonValue& texts = member(json, "texts", Kind::object, "an object", file);
  TextTable table;
  for (std::size_t i = 0; i < texts.keys.size(); ++i) {
    const std::string where = joinJsonPath("/texts", texts.keys[i]);
    const JsonValue& text = texts.items[i];
    if (text.kind != Kind::string || text.text.empty()) {
      throw Error("expected a string that is not empty, got " + describeJson(text), file.string(), where);
    }
    if (placesOf(text.text) != placesOf(texts.keys[i])) {
      throw Error("expected the same {} places as in English, got " + describeJson(text), file.string(),
                  where);
    }
    table[texts.keys[i]] = text.text;
  }
  return table;
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

void chooseLanguage(const std::string& code) {
  std::string wanted = code;
  if (code.empty()) {
    wanted = systemLanguage();
    std::error_code ignored;
    if (!fs::exists(languageFolder() / (wanted + ".json"), ignored)) wanted = "en";
  }
  setLanguage(wanted == "en" ? nullptr : &keptLanguage(wanted).texts);
}

}  // namespace anamorph
