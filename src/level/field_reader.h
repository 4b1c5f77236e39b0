// Reads fields out of a JSON object, strictly: a wrong type, a value out of its range and a missing key are faults,
// `line 7, column 31: /optic/shape/radius: expected a number from 0.000001 to 1000000, got -4`. They are gathered, not thrown,
// so that all of a file are told at once; what has one stays as it is, like an absent key that is not needed. Which
// fields there are is said by functions fields(at, part), found by the type of the part, once for reading, for writing
// (field_writer.h) and for the JSON Schema (field_schema.h).
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "level/choose.h"
#include "level/file_remarks.h"
#include "level/json.h"
#include "level/level.h"
#include "level/limits.h"
#include "optics/shape_fields.h"

namespace anamorph {

class FieldReader {
 public:
  /// What becomes of keys that no field asks for: a warning, or a fault.
  enum class UnknownKeys { kept, ignored, refused };

  /// Shared by the readers of one file.
  struct Context {
    explicit Context(std::string file, UnknownKeys unknown = UnknownKeys::kept)
        : remarks(std::move(file)), ifUnknown(unknown) {}

    FileRemarks remarks;
    UnknownKeys ifUnknown;
    std::vector<UnknownKey> unknownKeys;
  };

  /// It is a fault when `json` is no object: nothing more is said of it then.
  FieldReader(const JsonValue& json, std::string path, Context& context);

  /// It is a fault when one of them is missing.
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

  /// An array of as many numbers as there are values.
  void field(const char* key, std::span<double> values, Range range);
  /// An array of numbers, as many as `count` allows.
  void numbers(const char* key, std::vector<double>& values, Range range, Range count);
  /// An array of pairs of numbers.
  void curve(const char* key, std::vector<CurvePoint>& values, Range range, Range count);
  /// An array of rows of numbers, all of the same length.
  void grid(const char* key, HeightGrid& values, Range range, Range count);
  /// A number that files need not have.
  void optional(const char* key, double& value, double usual, Range range);

  /// Two whole numbers.
  void pair(const char* key, int& first, int& second, Range range);
  /// Three numbers, or one that is meant for all three.
  void factors(const char* key, Vector& value, Range range);
  /// A number, or "off" for 0.
  void numberOrOff(const char* key, double& value, Range range);
  /// A string of at most `most` bytes, empty where the file has none.
  void textOrNone(const char* key, std::string& value, std::size_t most);
  /// A string that is one of `names`.
  void oneOf(const char* key, std::string& value, const std::vector<std::string>& names);
  /// An object that is kept as text on one line, of at most `most` bytes. What it says is read as a Part by others.
  template <typename Part>
  void textOf(const char* key, std::string& json, std::size_t most) {
    opaque(key, json, most);
  }
  /// A string that is one of `allowed`, or an array of such; each at most once.
  void names(const char* key, std::vector<std::string>& values, const std::vector<std::string>& allowed);

  /// A string that is one of `names`; it chooses the enumerator, or the alternative of the variant, with its
  /// index. The key is needed: a name that is near to one of them is taken for it after the complaint, otherwise
  /// nothing more is said of this object.
  template <typename Choice, std::size_t count>
  void choice(const char* key, Choice& value, const std::array<const char*, count>& names) {
    if (const auto index = readChoice(key, {names.begin(), names.end()})) choose(value, *index);
  }

  /// The same for a list of names that is not known beforehand.
  void choice(const char* key, std::size_t& index, const std::vector<const char*>& names) {
    index = readChoice(key, {names.begin(), names.end()}).value_or(index);
  }

  /// An object whose fields are those of `part`.
  template <typename Part>
  void object(const char* key, Part&& part) {
    if (const JsonValue* json = find(key)) readObject(*json, pathOf(key), part);
  }

  /// An object that may be absent; then there is no part.
  template <typename Part>
  void optionalObject(const char* key, std::optional<Part>& part) {
    part.reset();
    if (has(key)) object(key, part.emplace());
  }

  /// An array of at most `most` objects; it replaces `parts`.
  template <typename Part>
  void list(const char* key, std::vector<Part>& parts, std::size_t most) {
    const JsonValue* json = find(key);
    if (!json || !isList(*json, pathOf(key), most)) return;
    parts.assign(json->items.size(), Part{});
    for (std::size_t i = 0; i < parts.size(); ++i) {
      readObject(json->items[i], joinJsonPath(pathOf(key), std::to_string(i)), parts[i]);
    }
  }

  /// The same; written only when there is one.
  template <typename Part>
  void listIfAny(const char* key, std::vector<Part>& parts, std::size_t most) {
    list(key, parts, most);
  }

  /// For conditions beyond ranges: "expected `what`, got the value of `key`" when not `holds`. Nothing where `key` has
  /// another fault.
  void expect(bool holds, const char* key, const std::string& what);

  /// To be called after the last field: tells of the keys that no field asked for.
  void finish();

 private:
  const JsonValue* find(std::string_view key);
  std::string pathOf(std::string_view key) const { return joinJsonPath(path_, key); }
  void fault(const std::string& message, const JsonValue& at, const std::string& path);
  void fail(const std::string& path, const std::string& expected, const JsonValue& got,
            const std::string& hint = {});
  std::optional<double> readNumber(const JsonValue& json, const std::string& path, Range range,
                                   bool whole = false);
  void readVector(const JsonValue& json, const std::string& path, Vector& value, Range range);
  bool isArray(const JsonValue& json, const std::string& path, const char* of, Range count);
  std::optional<std::size_t> readChoice(const char* key, const std::vector<std::string>& names);
  void opaque(const char* key, std::string& json, std::size_t most);
  bool areFew(const std::string& text, const JsonValue& json, const char* key, std::size_t most);
  bool isList(const JsonValue& json, const std::string& path, std::size_t most);
  bool isFaulty(std::string_view key) const;
  std::vector<std::string> absentKeys() const;

  template <typename Part>
  void readObject(const JsonValue& json, std::string path, Part& part) {
    FieldReader inner(json, std::move(path), context_);
    fields(inner, part);
    inner.finish();
  }

  const JsonValue& json_;
  std::string path_;
  Context& context_;
  std::vector<std::string_view> asked_;
  std::vector<std::string_view> faulty_;  // of those
  bool silent_ = false;                   // nothing more can be said of this object
  bool guessed_ = false;                  // which keys it needs is not certain
};

}  // namespace anamorph
