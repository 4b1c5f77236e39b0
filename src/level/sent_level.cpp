#include "level/sent_level.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "level/json.h"
#include "level/level_json.h"

namespace anamorph {
namespace {

constexpr std::string_view blanks = " \t\r\n";

bool isBlank(char c) {
  return blanks.find(c) != std::string_view::npos;
}

// Of numbers, true, false and null.
bool isOfWord(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == 'E' || c == '+' || c == '-' || c == '.';
}

// Follows JSON text character by character.
class StringFollower {
 public:
  void step(char c) {
    const bool quotes = c == '"' && !escaped_;
    escaped_ = inside_ && c == '\\' && !escaped_;
    if (quotes) inside_ = !inside_;
  }
  bool inside() const { return inside_; }
  bool escaped() const { return escaped_; }  ///< by the character before

 private:
  bool inside_ = false, escaped_ = false;
};

// Where the blanks that begin here end, if there is a line end among them; else `at`.
std::size_t endOfBreak(std::string_view text, std::size_t at) {
  if (!isBlank(text[at]) || (at > 0 && isBlank(text[at - 1]))) return at;
  const std::size_t end = std::min(text.find_first_not_of(blanks, at), text.size());
  return text.substr(at, end - at).find_first_of("\r\n") == std::string_view::npos ? at : end;
}

// How many characters at the line's front are marks of quoting: "> ", ">>", " > > ".
std::size_t lengthOfMarks(std::string_view line) {
  std::size_t length = 0;
  for (std::size_t i = 0; i < line.size() && (line[i] == '>' || line[i] == ' ' || line[i] == '\t'); ++i) {
    if (line[i] == '>') length = i + 1;
  }
  const bool blankFollows = length > 0 && length < line.size() && line[length] == ' ';
  return length + blankFollows;
}

// Whether a brace is in a quoted line: only then is a > at the beginning of a line no part of the level.
bool isQuoted(std::string_view text) {
  for (std::size_t brace = text.find('{'); brace != std::string_view::npos;) {
    const std::size_t begin = text.rfind('\n', brace) + 1;  // npos + 1 is 0
    if (lengthOfMarks(text.substr(begin, brace - begin)) > 0) return true;
    const std::size_t end = text.find('\n', brace);
    brace = end == std::string_view::npos ? end : text.find('{', end);
  }
  return false;
}

std::string withoutMarks(std::string_view text) {
  std::string bare;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    const std::string_view line = text.substr(0, end);
    bare += line.substr(lengthOfMarks(line));
    text.remove_prefix(end);
  }
  return bare;
}

bool opensObject(std::string_view text, std::size_t brace) {
  const std::size_t next = text.find_first_not_of(blanks, brace + 1);
  return next != std::string_view::npos && (text[next] == '"' || text[next] == '}');
}

struct Piece {
  std::size_t begin = 0, length = 0;
  bool closed = true;
};

// What is between the outermost braces; of several pieces the longest.
Piece findObject(std::string_view text) {
  std::vector<std::size_t> open;
  Piece longest;
  StringFollower string;
  const auto take = [&](std::size_t begin, std::size_t end, bool closed) {
    if (end - begin > longest.length) longest = {begin, end - begin, closed};
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (const std::size_t end = endOfBreak(text, i); end > i) {
      i = end - 1;
      continue;
    }
    if (open.empty()) string = {};  // quotation marks in the words around mean nothing
    string.step(text[i]);
    if (string.inside()) continue;
    if (text[i] == '{' && opensObject(text, i)) open.push_back(i);
    if (text[i] == '}' && !open.empty()) {
      take(open.back(), i + 1, true);
      open.pop_back();
    }
  }
  if (!open.empty()) take(open.front(), text.size(), false);
  return longest;
}

// Whether somebody wrote blanks into the strings, as formatSentLevel does not: beside a line end they may be a mailer's.
bool haveStringsBlanks(std::string_view json) {
  StringFollower string;
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (const std::size_t end = endOfBreak(json, i); end > i) {
      i = end - 1;
      continue;
    }
    string.step(json[i]);
    if (string.inside() && isBlank(json[i])) return true;
  }
  return false;
}

std::string withoutLineEnds(std::string_view json, bool& mended) {
  const bool wrappedAtBlanks = haveStringsBlanks(json);
  std::string whole;
  StringFollower string;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::size_t end = endOfBreak(json, i);
    if (end == i) {
      string.step(json[i]);
      whole += json[i];
      continue;
    }
    const bool inWord =
        !string.inside() && isOfWord(whole.back()) && end < json.size() && isOfWord(json[end]);
    if (!string.inside() && !inWord) whole += '\n';
    if (string.inside() && wrappedAtBlanks && !string.escaped()) whole += ' ';
    mended |= string.inside() || inWord;
    i = end - 1;
  }
  return whole;
}

bool isAllBlank(std::string_view text) {
  return text.find_first_not_of(blanks) == std::string_view::npos;
}

}  // namespace

std::string formatSentLevel(const Level& level) {
  return plainJson(parseJson(formatLevel(level), "the level"));
}

SentLevel readSentLevel(std::string_view text, const std::string& name) {
  if (text.size() > maxLevelBytes) {
    throw Error(fmt::format("expected at most {} MiB, got {} bytes", maxLevelBytes >> 20, text.size()), name);
  }
  if (isAllBlank(text)) throw Error("expected a level, got nothing", name);
  SentLevel sent;
  sent.mends.quoting = isQuoted(text);
  const std::string bare = sent.mends.quoting ? withoutMarks(text) : std::string(text);
  const Piece piece = findObject(bare);
  if (piece.length == 0) {
    throw Error("expected a level, {\"format\": \"anamorph-level\", ...}, got a text without one", name);
  }
  if (!piece.closed) {
    throw Error("expected a whole level, got one that ends before its last brace: it was cut off", name);
  }
  const std::string_view all = bare;
  sent.mends.wordsAround =
      !isAllBlank(all.substr(0, piece.begin)) || !isAllBlank(all.substr(piece.begin + piece.length));
  LoadedLevel loaded =
      parseLevel(withoutLineEnds(all.substr(piece.begin, piece.length), sent.mends.lineEnds), name);
  if (loaded.isThesisScene) throw Error("expected a level, got a scene of the thesis", name);
  sent.level = std::move(loaded.level);
  return sent;
}

}  // namespace anamorph
