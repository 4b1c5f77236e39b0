#include "level/field_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/spelling.h"
#include "base/text.h"

namespace anamorph {
namespace {

using Kind = JsonValue::Kind;

constexpr std::size_t mostHints = 100;

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
  if (json.kind == Kind::object) return;
  fail(path_, "an object", json);
  silent_ = true;
}

void FieldReader::need(std::initializer_list<const char*> keys) {
  need(std::vector<const char*>(keys));
}

void FieldReader::need(const std::vector<const char*>& keys) {
  std::vector<const char*> missing;
  for (const char* key : keys) {
    if (!silent_ && !find(key) && !isFaulty(key)) missing.push_back(key);
  }
  if (guessed_ && missing.size() > 1) return;  // the guess was a wrong one
  for (const char* key : missing) {
    find(key);  // the fault is of this one
    fault(fmt::format("expected the key {}, got an object without it", quoteJson(key)), json_, path_);
  }
}

void FieldReader::field(const char* key, bool& value) {
  const JsonValue* json = find(key);
  if (!json) return;
  if (json->kind != Kind::boolean) return fail(pathOf(key), "true or false", *json);
  value = json->text == "true";
}

void FieldReader::field(const char* key, std::string& value) {
  textOrNone(key, value, limits::mostTextBytes);
}

void FieldReader::textOrNone(const char* key, std::string& value, std::size_t most) {
  const JsonValue* json = find(key);
  if (!json) return;
  if (json->kind != Kind::string) return fail(pathOf(key), "a string", *json);
  if (areFew(json->text, *json, key, most)) value = json->text;
}

void FieldReader::field(const char* key, double& value, Range range) {
  if (const JsonValue* json = find(key)) value = readNumber(*json, pathOf(key), range).value_or(value);
}

void FieldReader::field(const char* key, int& value, Range range) {
  if (const JsonValue* json = find(key))
    value = static_cast<int>(readNumber(*json, pathOf(key), range, true).value_or(value));
}

void FieldReader::field(const char* key, std::size_t& value, Range range) {
  const JsonValue* json = find(key);
  if (!json) return;
  if (const auto number = readNumber(*json, pathOf(key), range, true))
    value = static_cast<std::size_t>(*number);
}

void FieldReader::field(const char* key, Vector& value, Range range) {
  if (const JsonValue* json = find(key)) readVector(*json, pathOf(key), value, range);
}

void FieldReader::field(const char* key, std::span<Point> values, Range range) {
  const JsonValue* json = find(key);
  if (!json) return;
  if (json->kind != Kind::array || json->items.size() != values.size()) {
    return fail(pathOf(key), fmt::format("an array of {} points", values.size()), *json);
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    readVector(json->items[i], joinJsonPath(pathOf(key), std::to_string(i)), values[i], range);
  }
}

void FieldReader::field(const char* key, std::span<double> values, Range range) {
  const JsonValue* json = find(key);
  if (!json) return;
  if (json->kind != Kind::array || json->items.size() != values.size()) {
    return fail(pathOf(key), fmt::format("an array of {} numbers", values.size()), *json);
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] =
        readNumber(json->items[i], joinJsonPath(pathOf(key), std::to_string(i)), range).value_or(values[i]);
  }
}

void FieldReader::numbers(const char* key, std::vector<double>& values, Range range, Range count) {
  const JsonValue* json = find(key);
  if (!json || !isArray(*json, pathOf(key), "numbers", count)) return;
  values.assign(json->items.size(), 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] =
        readNumber(json->items[i], joinJsonPath(pathOf(key), std::to_string(i)), range).value_or(range.max);
  }
}

void FieldReader::curve(const char* key, std::vector<CurvePoint>& values, Range range, Range count) {
  const JsonValue* json = find(key);
  if (!json || !isArray(*json, pathOf(key), "points", count)) return;
  values.assign(json->items.size(), CurvePoint(0));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const JsonValue& item = json->items[i];
    const std::string path = joinJsonPath(pathOf(key), std::to_string(i));
    if (!isArray(item, path, "numbers", {2, 2})) continue;
    for (int k = 0; k < 2; ++k) {
      values[i][k] =
          readNumber(item.items[static_cast<std::size_t>(k)], joinJsonPath(path, std::to_string(k)), range)
              .value_or(0);
    }
  }
}

void FieldReader::grid(const char* key, HeightGrid& values, Range range, Range count) {
  const JsonValue* json = find(key);
  if (!json || !isArray(*json, pathOf(key), "rows", count)) return;
  HeightGrid grid;
  for (std::size_t row = 0; row < json->items.size(); ++row) {
    const JsonValue& item = json->items[row];
    const std::string path = joinJsonPath(pathOf(key), std::to_string(row));
    const auto columns = static_cast<double>(grid.columns);
    if (!isArray(item, path, "numbers", row == 0 ? count : Range{columns, columns})) return;
    grid.columns = item.items.size();
    for (std::size_t i = 0; i < grid.columns; ++i) {
      grid.heights.push_back(
          readNumber(item.items[i], joinJsonPath(path, std::to_string(i)), range).value_or(0));
    }
  }
  values = std::move(grid);
}

void FieldReader::optional(const char* key, double& value, double usual, Range range) {
  value = usual;
  field(key, value, range);
}

void FieldReader::pair(const char* key, int& first, int& second, Range range) {
  const JsonValue* json = find(key);
  if (!json) return;
  if (json->kind != Kind::array || json->items.size() != 2)
    return fail(pathOf(key), "an array of 2 numbers", *json);
  first = static_cast<int>(readNumber(json->items[0], pathOf(key) + "/0", range, true).value_or(first));
  second = static_cast<int>(readNumber(json->items[1], pathOf(key) + "/1", range, true).value_or(second));
}

void FieldReader::factors(const char* key, Vector& value, Range range) {
  const JsonValue* json = find(key);
  if (!json) return;
  if (json->kind == Kind::number) {
    if (const auto factor = readNumber(*json, pathOf(key), range)) value = Vector(*factor);
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
  const bool inRange = json->kind == Kind::number && range.holds(json->number);
  if (!isZero && !isOff && !inRange)
    return fail(pathOf(key), "\"off\" or " + numbersFrom(range, false), *json);
  value = inRange ? json->number : 0;
}

void FieldReader::oneOf(const char* key, std::string& value, const std::vector<std::string>& names) {
  const JsonValue* json = find(key);
  if (!json) return;
  const bool known =
      json->kind == Kind::string && std::find(names.begin(), names.end(), json->text) != names.end();
  if (!known) return fail(pathOf(key), inQuotes(names), *json, didYouMean(json->text, names));
  value = json->text;
}

void FieldReader::names(const char* key, std::vector<std::string>& values,
                        const std::vector<std::string>& allowed) {
  const JsonValue* json = find(key);
  if (!json) return;
  const bool many = json->kind == Kind::array;
  for (const JsonValue& item : many ? json->items : std::vector<JsonValue>{*json}) {
    const bool known = std::find(allowed.begin(), allowed.end(), item.text) != allowed.end();
    const bool twice = std::find(values.begin(), values.end(), item.text) != values.end();
    if (item.kind != Kind::string || !known || twice) {
      return fail(pathOf(key), inQuotes(allowed) + ", or an array of some of them", *json,
                  known ? std::string() : didYouMean(item.text, allowed));
    }
    values.push_back(item.text);
  }
}

void FieldReader::opaque(const char* key, std::string& json, std::size_t most) {
  const JsonValue* value = find(key);
  if (!value) return;
  std::string text = compactJson(*value);
  if (areFew(text, *value, key, most)) json = std::move(text);
}

void FieldReader::expect(bool holds, const char* key, const std::string& what) {
  if (holds || silent_) return;
  if (isFaulty(key)) return;
  const JsonValue* json = find(key);
  fail(pathOf(key), what, json ? *json : JsonValue{});
}

void FieldReader::finish() {
  if (silent_) return;
  const std::vector<std::string> absent = absentKeys();
  for (std::size_t i = 0; i < json_.keys.size(); ++i) {
    const std::string& key = json_.keys[i];
    if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
    const JsonValue& value = json_.items[i];
    const std::string path = pathOf(key);
    // Of a heap of them none was meant to be something else, and looking would take its time.
    const std::string hint = context_.remarks.count() < mostHints ? didYouMean(key, absent) : "";
    if (context_.ifUnknown == UnknownKeys::refused) {
      context_.remarks.addFault("expected a key that is known here, got " + quoteJson(key) + hint,
                                value.keyPlace, path);
      continue;
    }
    const bool kept = context_.ifUnknown == UnknownKeys::kept;
    context_.remarks.addWarning((kept ? "unknown key, kept but not used" : "unknown key, ignored") + hint,
                                value.keyPlace, path);
    context_.unknownKeys.push_back({path_, key, compactJson(value)});
  }
}

const JsonValue* FieldReader::find(std::string_view key) {
  asked_.push_back(key);
  return silent_ ? nullptr : findMember(json_, key);
}

bool FieldReader::isFaulty(std::string_view key) const {
  return std::find(faulty_.begin(), faulty_.end(), key) != faulty_.end();
}

std::vector<std::string> FieldReader::absentKeys() const {
  std::vector<std::string> keys;
  for (const std::string_view key : asked_) {
    if (!findMember(json_, key)) keys.emplace_back(key);
  }
  return keys;
}

void FieldReader::fault(const std::string& message, const JsonValue& at, const std::string& path) {
  faulty_.push_back(asked_.empty() ? "" : asked_.back());
  context_.remarks.addFault(message, at.place, path);
}

void FieldReader::fail(const std::string& path, const std::string& expected, const JsonValue& got,
                       const std::string& hint) {
  fault("expected " + expected + ", got " + describeJson(got) + hint, got, path);
}

std::optional<double> FieldReader::readNumber(const JsonValue& json, const std::string& path, Range range,
                                              bool whole) {
  const double value = json.number;
  const bool isRight =
      json.kind == Kind::number && range.holds(value) && (!whole || value == std::floor(value));
  if (isRight) return value;
  fail(path, numbersFrom(range, whole), json);
  return std::nullopt;
}

void FieldReader::readVector(const JsonValue& json, const std::string& path, Vector& value, Range range) {
  if (json.kind != Kind::array || json.items.size() != 3) return fail(path, "an array of 3 numbers", json);
  for (int i = 0; i < 3; ++i) {
    const JsonValue& item = json.items[static_cast<std::size_t>(i)];
    value[i] = readNumber(item, joinJsonPath(path, std::to_string(i)), range).value_or(value[i]);
  }
}

bool FieldReader::isArray(const JsonValue& json, const std::string& path, const char* of, Range count) {
  const auto size = static_cast<double>(json.items.size());
  const std::string many = count.min == count.max
                               ? inFull(count.min)
                               : fmt::format("{} to {}", inFull(count.min), inFull(count.max));
  if (json.kind != Kind::array) {
    fail(path, fmt::format("an array of {} {}", many, of), json);
    return false;
  }
  if (count.holds(size)) return true;
  fault(fmt::format("expected {} {}, got {}", many, of, json.items.size()), json, path);
  return false;
}

std::optional<std::size_t> FieldReader::readChoice(const char* key, const std::vector<std::string>& names) {
  need({key});
  const JsonValue* json = find(key);
  const std::string text = json && json->kind == Kind::string ? json->text : "";
  auto name = std::find(names.begin(), names.end(), text);
  if (json && name == names.end()) {
    fail(pathOf(key), inQuotes(names), *json, didYouMean(text, names));
    name = std::find(names.begin(), names.end(), nearestWord(text, names));
    guessed_ = true;
  }
  silent_ |= name == names.end();
  return name == names.end() ? std::nullopt : std::optional(static_cast<std::size_t>(name - names.begin()));
}

bool FieldReader::areFew(const std::string& text, const JsonValue& json, const char* key, std::size_t most) {
  if (text.size() <= most) return true;
  fault(fmt::format("expected at most {} bytes, got {}", most, text.size()), json, pathOf(key));
  return false;
}

bool FieldReader::isList(const JsonValue& json, const std::string& path, std::size_t most) {
  if (json.kind != Kind::array) {
    fail(path, "an array", json);
    return false;
  }
  if (json.items.size() <= most) return true;
  fault(fmt::format("expected at most {} items, got {}", most, json.items.size()), json, path);
  return false;
}

}  // namespace anamorph
