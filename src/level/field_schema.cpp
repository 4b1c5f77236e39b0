#include "level/field_schema.h"

#include <algorithm>
#include <utility>

#include "level/json_object.h"

namespace anamorph {
namespace {

JsonValue numberSchema(Range range, const char* type = "number") {
  return JsonObject()
      .add("type", std::string(type))
      .add("minimum", range.min)
      .add("maximum", range.max)
      .value();
}

JsonValue arrayOf(const JsonValue& item, std::size_t least, std::size_t most) {
  return JsonObject()
      .add("type", std::string("array"))
      .add("items", item)
      .add("minItems", least)
      .add("maxItems", most)
      .value();
}

JsonValue arrayOf(const JsonValue& item, Range count) {
  return arrayOf(item, static_cast<std::size_t>(count.min), static_cast<std::size_t>(count.max));
}

JsonValue vectors(Range range) {
  return arrayOf(numberSchema(range), 3, 3);
}

JsonValue oneOfThese(const std::vector<std::string>& names) {
  return JsonObject().add("enum", textList(names)).value();
}

JsonValue anyOf(std::vector<JsonValue> schemas) {
  JsonValue list = emptyList();
  list.items = std::move(schemas);
  return JsonObject().add("anyOf", std::move(list)).value();
}

}  // namespace

void FieldSchema::need(const std::vector<const char*>& keys) {
  for (const char* key : keys) {
    if (std::find(needed_.begin(), needed_.end(), key) == needed_.end()) needed_.emplace_back(key);
  }
}

void FieldSchema::field(const char* key, bool&) {
  add(key, JsonObject().add("type", std::string("boolean")).value());
}

void FieldSchema::field(const char* key, double&, Range range) {
  add(key, numberSchema(range));
}

void FieldSchema::field(const char* key, int&, Range range) {
  add(key, numberSchema(range, "integer"));
}

void FieldSchema::field(const char* key, std::size_t&, Range range) {
  add(key, numberSchema(range, "integer"));
}

void FieldSchema::field(const char* key, Vector&, Range range) {
  add(key, vectors(range));
}

void FieldSchema::field(const char* key, std::span<Point> values, Range range) {
  add(key, arrayOf(vectors(range), values.size(), values.size()));
}

void FieldSchema::field(const char* key, std::span<double> values, Range range) {
  add(key, arrayOf(numberSchema(range), values.size(), values.size()));
}

void FieldSchema::numbers(const char* key, std::vector<double>&, Range range, Range count) {
  add(key, arrayOf(numberSchema(range), count));
}

void FieldSchema::curve(const char* key, std::vector<CurvePoint>&, Range range, Range count) {
  add(key, arrayOf(arrayOf(numberSchema(range), 2, 2), count));
}

void FieldSchema::grid(const char* key, HeightGrid&, Range range, Range count) {
  add(key, arrayOf(arrayOf(numberSchema(range), count), count));
}

void FieldSchema::pair(const char* key, int&, int&, Range range) {
  add(key, arrayOf(numberSchema(range, "integer"), 2, 2));
}

void FieldSchema::factors(const char* key, Vector&, Range range) {
  add(key, anyOf({numberSchema(range), vectors(range)}));
}

void FieldSchema::numberOrOff(const char* key, double&, Range range) {
  add(key, anyOf({oneOfThese({"off"}), numberSchema({0, 0}), numberSchema(range)}));
}

void FieldSchema::textOrNone(const char* key, std::string&, std::size_t most) {
  // In characters, where the limit is in bytes: what is too long here is too long there.
  add(key, JsonObject().add("type", std::string("string")).add("maxLength", most).value());
}

void FieldSchema::oneOf(const char* key, std::string&, const std::vector<std::string>& names) {
  add(key, oneOfThese(names));
}

void FieldSchema::names(const char* key, std::vector<std::string>&, const std::vector<std::string>& allowed) {
  add(key, anyOf({oneOfThese(allowed), arrayOf(oneOfThese(allowed), 0, allowed.size())}));
}

JsonValue FieldSchema::finish(const std::vector<std::string>& names) const {
  JsonObject properties;
  for (const auto& [key, schema] : properties_) {
    properties.add(key, key == choiceKey_ ? oneOfThese(names) : schema);
  }
  JsonObject object;
  object.add("type", std::string("object")).add("properties", properties.value());
  if (!needed_.empty()) object.add("required", textList(needed_));
  return object.add("additionalProperties", false).value();
}

void FieldSchema::add(const std::string& key, JsonValue schema) {
  properties_.emplace_back(key, std::move(schema));
}

void FieldSchema::addList(const char* key, const JsonValue& item, std::size_t most) {
  add(key, arrayOf(item, 0, most));
}

void FieldSchema::startChoice(const char* key, std::vector<std::string> names) {
  need({key});
  add(key, {});
  choiceKey_ = key;
  choices_ = std::move(names);
}

JsonValue schemaOfChoice(const std::vector<FieldSchema>& alternatives) {
  struct Group {
    const FieldSchema* schema;
    std::vector<std::string> names;
  };
  std::vector<Group> groups;
  const std::vector<std::string>& names = alternatives.front().choices();
  for (std::size_t i = 0; i < alternatives.size(); ++i) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
      return group.schema->finish({}) == alternatives[i].finish({});
    });
    Group& group = same == groups.end() ? groups.emplace_back(Group{&alternatives[i], {}}) : *same;
    if (!names.empty()) group.names.push_back(names[i]);
  }
  std::vector<JsonValue> schemas;
  for (const Group& group : groups) schemas.push_back(group.schema->finish(group.names));
  return schemas.size() == 1 ? schemas.front() : anyOf(std::move(schemas));
}

}  // namespace anamorph
