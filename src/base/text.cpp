#include "base/text.h"

namespace anamorph {

std::string alternatives(const std::vector<std::string>& texts) {
  std::string list;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (i > 0) list += i + 1 < texts.size() ? ", " : " or ";
    list += texts[i];
  }
  return list;
}

std::string withRemarks(std::string text, const std::vector<std::string>& remarks) {
  for (const std::string& remark : remarks) text += "; " + remark;
  return text;
}

}  // namespace anamorph
