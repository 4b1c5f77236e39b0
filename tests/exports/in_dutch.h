// The installed Dutch table in force, as long as the object lives.
#pragma once

#include <string>

#include "base/file.h"
#include "base/language.h"
#include "level/json.h"

namespace anamorph::testing {

class InDutch {
 public:
  InDutch() {
    static const TextTable table = read();  // texts that were handed out stay valid
    setLanguage(&table);
  }
  ~InDutch() { setLanguage(nullptr); }
  InDutch(const InDutch&) = delete;
  InDutch& operator=(const InDutch&) = delete;

 private:
  static TextTable read() {
    const std::string file = std::string(ANAMORPH_SOURCE_DIR) + "/assets/languages/nl.json";
    const JsonValue json = parseJson(readFile(file, std::size_t{1} << 20).view(), file);
    const JsonValue* texts = findMember(json, "texts");
    TextTable table;
    for (std::size_t i = 0; texts && i < texts->keys.size(); ++i)
      table[texts->keys[i]] = texts->items[i].text;
    return table;
  }
};

}  // namespace anamorph::testing
