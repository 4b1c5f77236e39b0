#include "base/text.h"

namespace anamorph {

std::string alternatives(const std::vector<std::string>& texts, const std::string& word) {
  std::string list;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (i > 0) list += i + 1 < texts.size() ? ", " : " " + word + " ";
    list += texts[i];
  }
  return list;
}

}  // namespace anamorph
