// Reads fields out of a JSON object, strictly: a wrong type, a value out of its range and a missing key throw
// Error with the JSON pointer, `/optic/shape/radius: expected a number from 0.000001 to 1000000, got -4`. An
// absent key that is not needed leaves the value as it is. Which fields there are is said by functions
// fields(at, part), found by the type of the part, once for reading and for writing (field_writer.h).
#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "level/json.h"
#include "level/level.h"
#include "level/limits.h"

namespace anamorph {

class FieldReader {
 public:
  /// Shared by the readers of one file.
  struct Context {
    std::string file;
    std::vector<UnknownKey> unknownKeys;
  };

  /// Throws Error when `json` is not an object.
  FieldReader(const JsonValue& json, std::string path, Context& context);

  /// Throws Error when one of them is missing.
  void need(std::initializer_list<const char*> keys);
  void need(const std::vector<const char*>& keys);

  bool has(const char* key) { return find(key) != nullptr; }

  void field(const char* key, bool& value);
  /// Of at most limits::mostTextBytes.
  void field(const char* key, std::string& value);
  void field(const char* key, double& value, Range range);
  void field(const char* key, int& value, Range range);
  void field(const char* key, std::size_t& value, Range range);
  void field(const char* key, Vector& value, Range range);
  void field(const char* key, std::span<Point> values, Range range);

  /// Two whole numbers.
  void pair(const char* key, int& first, int& second, Range range);
  /// Three numbers, or one that is meant for all three.
  void factors(const char* key, Vector& value, Range range);
  /// A number, or "off" for 0.
  void numberOrOff(const char* key, double& value, Range range);
  /// A string of at most `most` bytes, empty where the file has none.
  void textOrNone(const char* key, std::string& value, std::size_t most);
  /// Any JSON, as text on one line of at most `most` bytes.
  void opaque(const char* key, std::string& json, std::size_t most);

  /// A string that is one of `names`; it chooses the enumerator, or the alternative of the variant, with its
  /// index. The key is needed.
  template <typename Choice, std::size_t count>
  void choice(const char* key, Choice& value, const std::array<const char*, count>& names) {
    choose(value, readChoice(key, {names.begin(), names.end()}));
  }

  /// The same for a list of names that is not known beforehand.
  void choice(const char* key, std::size_t& index, const std::vector<const char*>& names) {
    index = readChoice(key, {names.begin(), names.end()});
  }

  /// An object whose fields are those of `part`.
  template <typename Part>
  void object(const char* key, Part&& part) {
    if (const JsonValue* json = find(key)) readObject(*json, pathOf(key), part);
  }

  /// An array of at most `most` objects; it replaces `parts`.
  template <typename Part>
  void list(const char* key, std::vector<Part>& parts, std::size_t most) {
    const JsonValue* json = find(key);
    if (!json) return;
    checkList(*json, pathOf(key), most);
    parts.assign(json->items.size(), Part{});
    for (std::size_t i = 0; i < parts.size(); ++i) {
      readObject(json->items[i], joinJsonPath(pathOf(key), std::to_string(i)), parts[i]);
    }
  }

  /// For conditions beyond ranges: throws Error "expected `what`, got the value of `key`" when not `holds`.
  void expect(bool holds, const char* key, const std::string& what);

  /// To be called after the last field: adds the keys that no field asked for to the context.
  void finish();

 private:
  const JsonValue* find(std::string_view key);
  std::string pathOf(std::string_view key) const { return joinJsonPath(path_, key); }
  [[noreturn]] void fail(const std::string& path, const std::string& expected, const JsonValue& got) const;
  double readNumber(const JsonValue& json, const std::string& path, Range range, bool whole = false) const;
  void readVector(const JsonValue& json, const std::string& path, Vector& value, Range range) const;
  std::size_t readChoice(const char* key, const std::vector<std::string>& names);
  void checkBytes(const std::string& text, const char* key, std::size_t most) const;
  void checkList(const JsonValue& json, const std::string& path, std::size_t most) const;

  template <typename Part>
  void readObject(const JsonValue& json, std::string path, Part& part) {
    FieldReader inner(json, std::move(path), context_);
    fields(inner, part);
    inner.finish();
  }

  template <typename Enum>
  requires std::is_enum_v<Enum>
  static void choose(Enum& value, std::size_t index) { value = static_cast<Enum>(index); }
  template <typename... Alternative>
  static void choose(std::variant<Alternative...>& value, std::size_t index) {
    std::size_t i = 0;
    ((i++ == index ? static_cast<void>(value.template emplace<Alternative>()) : void()), ...);
  }

  const JsonValue& json_;
  std::string path_;
  Context& context_;
  std::vector<std::string_view> asked_;
};

}  // namespace anamorph
