#include "level/field_writer.h"

#include <fmt/format.h>

#include <algorithm>

namespace anamorph {
namespace {

using Kind = JsonValue::Kind;

JsonValue scalar(Kind kind, std::string text) {
  JsonValue json;
  json.kind = kind;
  json.text = std::move(text);
  return json;
}

// fmt writes the shortest text that reads back as the same number.
template <typename Number>
JsonValue number(Number value) {
  return scalar(Kind::number, fmt::format("{}", value));
}

JsonValue array(std::vector<JsonValue> items) {
  JsonValue json;
  json.kind = Kind::array;
  json.items = std::move(items);
  return json;
}

JsonValue array(std::span<const double> numbers) {
  std::vector<JsonValue> items;
  for (const double value : numbers) items.push_back(number(value));
  return array(std::move(items));
}

JsonValue vector(const Vector& v) {
  return array({number(v.x), number(v.y), number(v.z)});
}

}  // namespace

FieldWriter::FieldWriter(std::string path, const std::vector<UnknownKey>& unknownKeys)
    : path_(std::move(path)), unknownKeys_(unknownKeys) {
  json_.kind = Kind::object;
}

void FieldWriter::field(const char* key, bool value) {
  add(key, scalar(Kind::boolean, value ? "true" : "false"));
}

void FieldWriter::field(const char* key, const std::string& value) {
  add(key, scalar(Kind::string, value));
}

void FieldWriter::field(const char* key, double value, Range) {
  add(key, number(value));
}

void FieldWriter::field(const char* key, int value, Range) {
  add(key, number(value));
}

void FieldWriter::field(const char* key, std::size_t value, Range) {
  add(key, number(value));
}

void FieldWriter::field(const char* key, const Vector& value, Range) {
  add(key, vector(value));
}

void FieldWriter::field(const char* key, std::span<const Point> values, Range) {
  std::vector<JsonValue> items;
  for (const Point& value : values) items.push_back(vector(value));
  add(key, array(std::move(items)));
}

void FieldWriter::field(const char* key, std::span<const double> values, Range) {
  add(key, array(values));
}

void FieldWriter::numbers(const char* key, const std::vector<double>& values, Range, Range) {
  add(key, array(values));
}

void FieldWriter::curve(const char* key, const std::vector<CurvePoint>& values, Range, Range) {
  std::vector<JsonValue> items;
  for (const CurvePoint& value : values) items.push_back(array({number(value.x), number(value.y)}));
  add(key, array(std::move(items)));
}

void FieldWriter::grid(const char* key, const HeightGrid& values, Range, Range) {
  std::vector<JsonValue> rows;
  for (std::size_t row = 0; row < values.rows(); ++row) {
    rows.push_back(array(std::span(values.heights).subspan(row * values.columns, values.columns)));
  }
  add(key, array(std::move(rows)));
}

void FieldWriter::optional(const char* key, double value, double usual, Range range) {
  if (value != usual) field(key, value, range);
}

void FieldWriter::pair(const char* key, int first, int second, Range) {
  add(key, array({number(first), number(second)}));
}

void FieldWriter::factors(const char* key, const Vector& value, Range) {
  add(key, value == Vector(value.x) ? number(value.x) : vector(value));
}

void FieldWriter::numberOrOff(const char* key, double value, Range) {
  add(key, value == 0 ? scalar(Kind::string, "off") : number(value));
}

void FieldWriter::textOrNone(const char* key, const std::string& value, std::size_t /*most*/) {
  if (!value.empty()) field(key, value);
}

void FieldWriter::opaque(const char* key, const std::string& json) {
  if (!json.empty()) add(key, parseJson(json, key));
}

JsonValue FieldWriter::finish() {
  // A key that was unknown to one shape may be known to another that was chosen since: the known one wins.
  const std::vector<std::string> known = json_.keys;
  for (const UnknownKey& unknown : unknownKeys_) {
    if (unknown.object != path_ || std::find(known.begin(), known.end(), unknown.key) != known.end())
      continue;
    add(unknown.key, parseJson(unknown.json, unknown.key));
  }
  return std::move(json_);
}

void FieldWriter::add(const std::string& key, JsonValue value) {
  json_.keys.push_back(key);
  json_.items.push_back(std::move(value));
}

}  // namespace anamorph
