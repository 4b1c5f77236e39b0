#include "base/text.h"

#include <algorithm>

namespace anamorph {
namespace {

bool isContinuation(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

char32_t codePoint(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return first;
  char32_t code = first & (0x7Fu >> character.size());
  for (const char c : character.substr(1)) code = code << 6 | (static_cast<unsigned char>(c) & 0x3Fu);
  return code;
}

struct CodeRange {
  char32_t first, last;
};

// What a terminal obeys instead of showing it.
constexpr CodeRange commands[] = {
    {0x00, 0x1F},     {0x7F, 0x9F},      // C0, delete, C1
    {0x061C, 0x061C}, {0x200E, 0x200F},  // marks of direction
    {0x2028, 0x202E},                    // ends of lines and paragraphs, overrides of the direction
    {0x2066, 0x2069}, {0xFEFF, 0xFEFF},  // isolates, the byte order mark
    {0xFFF9, 0xFFFB}, {0xE0000, 0xE007F}};

bool isCommand(char32_t code) {
  return std::any_of(std::begin(commands), std::end(commands),
                     [=](const CodeRange& range) { return code >= range.first && code <= range.last; });
}

void appendEscaped(std::string& out, std::string_view bytes) {
  if (bytes == "\n" || bytes == "\t") {
    out += bytes == "\n" ? "\\n" : "\\t";
    return;
  }
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    out += '\\';
    for (const int shift : {6, 3, 0}) out += static_cast<char>('0' + (byte >> shift & 7));
  }
}

}  // namespace

std::string alternatives(const std::vector<std::string>& texts, const std::string& word) {
  std::string list;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (i > 0) list += i + 1 < texts.size() ? ", " : " " + word + " ";
    list += texts[i];
  }
  return list;
}

std::string withRemarks(std::string text, const std::vector<std::string>& remarks) {
  for (const std::string& remark : remarks) text += "; " + remark;
  return text;
}

// Unicode table 3-7.
std::size_t characterLength(std::string_view text) {
  if (text.empty()) return 0;
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!isContinuation(text[i])) return 0;
  }
  const auto second = static_cast<unsigned char>(text[1]);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second > 0x9F, tooLarge = first == 0xF4 && second > 0x8F;
  return overlong || surrogate || tooLarge ? 0 : length;
}

std::string shortened(std::string text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && isContinuation(text[most])) --most;
  return text.substr(0, most) + "...";
}

std::string printable(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = characterLength(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    if (length == 0 || isCommand(codePoint(character))) {
      appendEscaped(out, character);
    } else {
      out += character;
    }
    text.remove_prefix(character.size());
  }
  return out;
}

}  // namespace anamorph
