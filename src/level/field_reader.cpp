#include "level/field_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "base/error.h"
#include "base/text.h"

namespace anamorph {
namespace {

using Kind = JsonValue::Kind;

std::string inQuotes(const std::vector<std::string>& names) {
  std::vector<std::string> quoted;
  for (const std::string& name : names) quoted.push_back(quoteJson(name));
  return alternatives(quoted);
}

// In full, as one types it: not 1e+08.
std::string inFull(double number) {
  std::string text = fmt::format("{:.9f}", number);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string numbersFrom(Range range, bool whole) {
  return fmt::format("a {} from {} to {}", whole ? "whole number" : "number", inFull(range.min),
                     inFull(range.max));
}

}  // namespace

FieldReader::FieldReader(const JsonValue& json, std::string path, Context& context)
    : json_(json), path_(std::move(path)), context_(context) {
  if (json.kind != Kind::object) fail(path_, "an object", json);
}

void FieldReader::need(std::initializer_list<const char*> keys) {
  need(std::vector<const char*>(keys));
}

void FieldReader::need(const std::vector<const char*>& keys) {
  for (const char* key : keys) {
    if (find(key)) continue;
    throw Error(fmt::format("expected the key {}, got an object without it", quoteJson(key)), context_.file,
                path_);
  }
}

void FieldReader::field(const char* key, bool& value) {
  const JsonValue* json = find(key);
  if (!json) return;
  if (json->kind != Kind::boolean) fail(pathOf(key), "true or false", *json);
  value = json->text == "true";
}

void FieldReader::field(const char* key, std::string& value) {
  textOrNone(key, value, limits::mostTextBytes);
}

void FieldReader::textOrNone(const char* key, std::string& value, std::size_t most) {
  const JsonValue* json = find(key);
  if (!json) return;
  if (json->kind != Kind::string) fail(pathOf(key), "a string", *json);
  checkBytes(json->text, key, most);
  value = json->text;
}

void FieldReader::field(const char* key, double& value, Range range) {
  if (const JsonValue* json = find(key)) value = readNumber(*json, pathOf(key), range);
}

void FieldReader::field(const char* key, int& value, Range range) {
  if (const JsonValue* json = find(key))
    value = static_cast<int>(readNumber(*json, pathOf(key), range, true));
}

void FieldReader::field(const char* key, std::size_t& value, Range range) {
  if (const JsonValue* json = find(key)) {
    value = static_cast<std::size_t>(readNumber(*json, pathOf(key), range, true));
  }
}

void FieldReader::field(const char* key, Vector& value, Range range) {
  if (const JsonValue* json = find(key)) readVector(*json, pathOf(key), value, range);
}

void FieldReader::field(const char* key, std::span<Point> values, Range range) {
  const JsonValue* json = find(key);
  if (!json) return;
  if (json->kind != Kind::array || json->items.size() != values.size()) {
    fail(pathOf(key), fmt::format("an array of {} points", values.size()), *json);
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    readVector(json->items[i], joinJsonPath(pathOf(key), std::to_string(i)), values[i], range);
  }
}

void FieldReader::pair(const char* key, int& first, int& second, Range range) {
  const JsonValue* json = find(key);
  if (!json) return;
  if (json->kind != Kind::array || json->items.size() != 2) fail(pathOf(key), "an array of 2 numbers", *json);
  first = static_cast<int>(readNumber(json->items[0], pathOf(key) + "/0", range, true));
  second = static_cast<int>(readNumber(json->items[1], pathOf(key) + "/1", range, true));
}

void FieldReader::factors(const char* key, Vector& value, Range range) {
  const JsonValue* json = find(key);
  if (!json) return;
  if (json->kind == Kind::number) {
    value = Vector(readNumber(*json, pathOf(key), range));
  } else if (json->kind == Kind::array) {
    readVector(*json, pathOf(key), value, range);
  } else {
    fail(pathOf(key), "a number or an array of 3 numbers", *json);
  }
}

void FieldReader::numberOrOff(const char* key, double& value, Range range) {
  const JsonValue* json = find(key);
  if (!json) return;
  const bool isZero = json->kind == Kind::number && json->number == 0;
  const bool isOff = json->kind == Kind::string && json->text == "off";
  const bool inRange = json->kind == Kind::number && json->number >= range.min && json->number <= range.max;
  if (!isZero && !isOff && !inRange) fail(pathOf(key), "\"off\" or " + numbersFrom(range, false), *json);
  value = inRange ? json->number : 0;
}

void FieldReader::opaque(const char* key, std::string& json, std::size_t most) {
  const JsonValue* value = find(key);
  if (!value) return;
  json = compactJson(*value);
  checkBytes(json, key, most);
}

void FieldReader::expect(bool holds, const char* key, const std::string& what) {
  if (holds) return;
  const JsonValue* json = find(key);
  fail(pathOf(key), what, json ? *json : JsonValue{});
}

void FieldReader::finish() {
  for (std::size_t i = 0; i < json_.keys.size(); ++i) {
    const std::string& key = json_.keys[i];
    if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
    context_.unknownKeys.push_back({path_, key, compactJson(json_.items[i])});
  }
}

const JsonValue* FieldReader::find(std::string_view key) {
  asked_.push_back(key);
  return findMember(json_, key);
}

void FieldReader::fail(const std::string& path, const std::string& expected, const JsonValue& got) const {
  throw Error("expected " + expected + ", got " + describeJson(got), context_.file, path);
}

double FieldReader::readNumber(const JsonValue& json, const std::string& path, Range range,
                               bool whole) const {
  const double value = json.number;
  const bool isRight = json.kind == Kind::number && value >= range.min && value <= range.max &&
                       (!whole || value == std::floor(value));
  if (!isRight) fail(path, numbersFrom(range, whole), json);
  return value;
}

void FieldReader::readVector(const JsonValue& json, const std::string& path, Vector& value,
                             Range range) const {
  if (json.kind != Kind::array || json.items.size() != 3) fail(path, "an array of 3 numbers", json);
  for (int i = 0; i < 3; ++i) {
    value[i] =
        readNumber(json.items[static_cast<std::size_t>(i)], joinJsonPath(path, std::to_string(i)), range);
  }
}

std::size_t FieldReader::readChoice(const char* key, const std::vector<std::string>& names) {
  need({key});
  const JsonValue& json = *find(key);
  const auto name = std::find(names.begin(), names.end(), json.text);
  if (json.kind != Kind::string || name == names.end()) fail(pathOf(key), inQuotes(names), json);
  return static_cast<std::size_t>(name - names.begin());
}

void FieldReader::checkBytes(const std::string& text, const char* key, std::size_t most) const {
  if (text.size() <= most) return;
  throw Error(fmt::format("expected at most {} bytes, got {}", most, text.size()), context_.file,
              pathOf(key));
}

void FieldReader::checkList(const JsonValue& json, const std::string& path, std::size_t most) const {
  if (json.kind != Kind::array) fail(path, "an array", json);
  if (json.items.size() <= most) return;
  throw Error(fmt::format("expected at most {} items, got {}", most, json.items.size()), context_.file, path);
}

}  // namespace anamorph
