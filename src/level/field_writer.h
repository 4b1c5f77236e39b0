// Writes the fields that FieldReader reads, in the same order and under the same names, because both walk the
// same functions fields(at, part). Ranges are the reader's business; keys that came from a file without being
// known go back to the end of their object.
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "level/field_reader.h"
#include "level/json.h"
#include "level/level.h"

namespace anamorph {

class FieldWriter {
 public:
  FieldWriter(std::string path, const std::vector<UnknownKey>& unknownKeys);

  void need(std::initializer_list<const char*>) {}
  void need(const std::vector<const char*>&) {}
  void expect(bool, const char*, const std::string&) {}

  void field(const char* key, bool value);
  void field(const char* key, const std::string& value);
  void field(const char* key, double value, Range);
  void field(const char* key, int value, Range);
  void field(const char* key, std::size_t value, Range);
  void field(const char* key, const Vector& value, Range);
  void field(const char* key, std::span<const Point> values, Range);
  void field(const char* key, std::span<const double> values, Range);
  void numbers(const char* key, const std::vector<double>& values, Range, Range);
  void curve(const char* key, const std::vector<CurvePoint>& values, Range, Range);
  void grid(const char* key, const HeightGrid& values, Range, Range);
  /// Nothing is written for the usual number.
  void optional(const char* key, double value, double usual, Range range);
  void pair(const char* key, int first, int second, Range);
  void factors(const char* key, const Vector& value, Range);
  void numberOrOff(const char* key, double value, Range);
  /// Nothing is written for an empty text.
  void textOrNone(const char* key, const std::string& value, std::size_t most);
  /// Nothing is written for an empty text. Throws Error when it is not JSON.
  template <typename Part>
  void textOf(const char* key, const std::string& json, std::size_t) {
    opaque(key, json);
  }

  template <typename Choice, std::size_t count>
  void choice(const char* key, const Choice& value, const std::array<const char*, count>& names) {
    field(key, std::string(names[chosen(value)]));
  }

  void choice(const char* key, std::size_t index, const std::vector<const char*>& names) {
    field(key, std::string(names.at(index)));
  }

  template <typename Part>
  void object(const char* key, Part&& part) {
    add(key, writeObject(joinJsonPath(path_, key), part));
  }

  template <typename Part>
  void optionalObject(const char* key, std::optional<Part>& part) {
    if (part) object(key, *part);
  }

  template <typename Part>
  void list(const char* key, std::vector<Part>& parts, std::size_t) {
    JsonValue json;
    json.kind = JsonValue::Kind::array;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      json.items.push_back(writeObject(joinJsonPath(joinJsonPath(path_, key), std::to_string(i)), parts[i]));
    }
    add(key, std::move(json));
  }

  template <typename Part>
  void listIfAny(const char* key, std::vector<Part>& parts, std::size_t most) {
    if (!parts.empty()) list(key, parts, most);
  }

  /// To be called after the last field: the object, with its unknown keys.
  JsonValue finish();

 private:
  void add(const std::string& key, JsonValue value);
  void opaque(const char* key, const std::string& json);

  template <typename Part>
  JsonValue writeObject(std::string path, Part& part) {
    FieldWriter inner(std::move(path), unknownKeys_);
    fields(inner, part);
    return inner.finish();
  }

  template <typename Enum>
  requires std::is_enum_v<Enum>
  static std::size_t chosen(Enum value) { return static_cast<std::size_t>(value); }
  template <typename... Alternative>
  static std::size_t chosen(const std::variant<Alternative...>& value) {
    return value.index();
  }

  std::string path_;
  const std::vector<UnknownKey>& unknownKeys_;
  JsonValue json_;
};

}  // namespace anamorph
