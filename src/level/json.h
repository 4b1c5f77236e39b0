// JSON as plain data: read strictly, written for people. A thin layer over nlohmann-json, the only one: it
// adds what a file made by hand needs and the library does not give, namely each key once, a limit to depth
// and size, numbers kept as they were written, the key order of the file, and short values on one line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "level/json_places.h"

namespace anamorph {

class FileRemarks;

/// Deeper documents are refused while they are read, so that no later recursion is deep.
constexpr std::size_t maxJsonDepth = 64;
/// A limit to the memory a document takes: about 150 bytes a value.
constexpr std::size_t maxJsonValues = 1000000;

struct JsonValue {
  enum class Kind { null, boolean, number, string, array, object };

  Kind kind = Kind::null;
  std::string text;               ///< a string's characters; a number or boolean as it is written
  double number = 0;              ///< finite
  std::vector<std::string> keys;  ///< of an object, in the order of the file, each once
  std::vector<JsonValue> items;   ///< of an array, or the values that belong to the keys
  JsonPlace place{};              ///< where it begins
  JsonPlace keyPlace{};           ///< of an object's item: where its key begins

  bool operator==(const JsonValue&) const = default;
};

/// Reads one document. Throws Error with line and column, byte or JSON pointer of what is wrong; `fileName`
/// is only for the message. A byte order mark is skipped.
JsonValue parseJson(std::string_view text, const std::string& fileName);
/// The same, but a comma before a closing bracket, as other languages allow it, is a fault that hides no other one.
JsonValue parseJson(std::string_view text, FileRemarks& remarks);

/// The value of an object's key; null when it has not got it, or is no object.
const JsonValue* findMember(const JsonValue& object, std::string_view key);

/// What a JSON pointer leads to; null when there is nothing.
const JsonValue* findByPath(const JsonValue& document, std::string_view path);

/// Indented by 2, a line for each item; values without objects inside stay on one line where they fit in 100
/// columns.
std::string formatJson(const JsonValue& value);

/// The same on one line.
std::string compactJson(const JsonValue& value);

/// The same in plain ASCII, without blanks and > inside its strings (they are escaped): whatever has wrapped or quoted
/// the line since can be told from it.
std::string plainJson(const JsonValue& value);

/// In quotes, escaped; bytes that are not UTF-8 are replaced.
std::string quoteJson(std::string_view text);

/// The JSON pointer (RFC 6901) of an object's member or of an array's element.
std::string joinJsonPath(const std::string& path, std::string_view key);

/// What a message shows of a value: short ones as they are, long ones cut, containers by their kind.
std::string describeJson(const JsonValue& value);

}  // namespace anamorph
