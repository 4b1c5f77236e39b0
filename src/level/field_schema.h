// Describes the fields that FieldReader reads as a JSON Schema, by which editors complete and check what is written. It
// walks the same functions fields(at, part), so the schema has no list of its own. Where a name chooses which fields
// follow (choice), they are walked once for each name.
//
// A schema says less than the reader, which also knows conditions between fields (expect), and more about unknown keys:
// those of a level are only warned about when it is read, here they are errors, as misspelt keys are to an editor.
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "level/choose.h"
#include "level/json.h"
#include "level/level.h"
#include "level/limits.h"
#include "optics/shape_fields.h"

namespace anamorph {

class FieldSchema {
 public:
  /// Which of the names each choice() takes.
  explicit FieldSchema(std::size_t chosen) : chosen_(chosen) {}

  bool has(const char*) { return true; }
  void need(std::initializer_list<const char*> keys) { need(std::vector<const char*>(keys)); }
  void need(const std::vector<const char*>& keys);
  void expect(bool, const char*, const std::string&) {}

  void field(const char* key, bool&);
  void field(const char* key, std::string& value) { textOrNone(key, value, limits::mostTextBytes); }
  void field(const char* key, double&, Range range);
  void field(const char* key, int&, Range range);
  void field(const char* key, std::size_t&, Range range);
  void field(const char* key, Vector&, Range range);
  void field(const char* key, std::span<Point> values, Range range);
  void field(const char* key, std::span<double> values, Range range);
  void numbers(const char* key, std::vector<double>&, Range range, Range count);
  void curve(const char* key, std::vector<CurvePoint>&, Range range, Range count);
  void grid(const char* key, HeightGrid&, Range range, Range count);
  void optional(const char* key, double& value, double /*usual*/, Range range) { field(key, value, range); }
  void pair(const char* key, int&, int&, Range range);
  void factors(const char* key, Vector&, Range range);
  void numberOrOff(const char* key, double&, Range range);
  void textOrNone(const char* key, std::string&, std::size_t most);
  void oneOf(const char* key, std::string&, const std::vector<std::string>& names);
  /// One of them, or an array of some.
  void names(const char* key, std::vector<std::string>&, const std::vector<std::string>& allowed);
  template <typename Part>
  void textOf(const char* key, std::string&, std::size_t) {
    add(key, jsonSchema(Part{}));
  }

  template <typename Choice, std::size_t count>
  void choice(const char* key, Choice& value, const std::array<const char*, count>& names) {
    startChoice(key, {names.begin(), names.end()});
    choose(value, chosen_);
  }
  void choice(const char* key, std::size_t& index, const std::vector<const char*>& names) {
    startChoice(key, {names.begin(), names.end()});
    index = chosen_;
  }

  template <typename Part>
  void object(const char* key, Part&& part);
  template <typename Part>
  void optionalObject(const char* key, std::optional<Part>&) {
    object(key, Part{});
  }
  template <typename Part>
  void list(const char* key, std::vector<Part>&, std::size_t most);

  template <typename Part>
  void listIfAny(const char* key, std::vector<Part>& parts, std::size_t most) {
    list(key, parts, most);
  }

  /// The names of the choice that was met; empty: none.
  const std::vector<std::string>& choices() const { return choices_; }
  /// The object's schema, with these names for the choice.
  JsonValue finish(const std::vector<std::string>& names) const;

 private:
  void add(const std::string& key, JsonValue schema);
  void addList(const char* key, const JsonValue& item, std::size_t most);
  void startChoice(const char* key, std::vector<std::string> names);

  std::size_t chosen_;
  std::string choiceKey_;  // empty: none
  std::vector<std::string> choices_, needed_;
  std::vector<std::pair<std::string, JsonValue>> properties_;
};

/// One of several schemas, each with the names of the choice that it is for: names with the same fields go together.
JsonValue schemaOfChoice(const std::vector<FieldSchema>& alternatives);

/// The schema of an object with the fields of `part`.
template <typename Part>
JsonValue schemaOf(const Part& part) {
  std::vector<FieldSchema> alternatives;
  do {
    Part walked = part;  // a choice changes it
    fields(alternatives.emplace_back(alternatives.size()), walked);
  } while (alternatives.size() < alternatives.front().choices().size());
  return schemaOfChoice(alternatives);
}

template <typename Part>
void FieldSchema::object(const char* key, Part&& part) {
  add(key, schemaOf<std::remove_cvref_t<Part>>(part));
}

template <typename Part>
void FieldSchema::list(const char* key, std::vector<Part>&, std::size_t most) {
  addList(key, schemaOf(Part{}), most);
}

}  // namespace anamorph
