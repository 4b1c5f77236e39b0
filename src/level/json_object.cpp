#include "level/json_object.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace anamorph {
namespace {

JsonValue numberJson(double number) {
  if (!std::isfinite(number)) return {};
  return {JsonValue::Kind::number, fmt::format("{}", number), number, {}, {}};
}

}  // namespace

JsonValue emptyList() {
  return {JsonValue::Kind::array, {}, 0, {}, {}};
}

JsonValue textList(const std::vector<std::string>& texts) {
  JsonValue list = emptyList();
  for (const std::string& text : texts) list.items.push_back({JsonValue::Kind::string, text, 0, {}, {}});
  return list;
}

JsonObject& JsonObject::add(const std::string& key, JsonValue value) {
  value_.keys.push_back(key);
  value_.items.push_back(std::move(value));
  return *this;
}

JsonObject& JsonObject::add(const std::string& key, double value) {
  return add(key, numberJson(value));
}

JsonObject& JsonObject::add(const std::string& key, std::size_t value) {
  return add(key,
             JsonValue{JsonValue::Kind::number, std::to_string(value), static_cast<double>(value), {}, {}});
}

JsonObject& JsonObject::add(const std::string& key, bool value) {
  return add(key, JsonValue{JsonValue::Kind::boolean, value ? "true" : "false", 0, {}, {}});
}

JsonObject& JsonObject::add(const std::string& key, const std::string& value) {
  return add(key, JsonValue{JsonValue::Kind::string, value, 0, {}, {}});
}

JsonObject& JsonObject::add(const std::string& key, const Vector& value) {
  JsonValue array = emptyList();
  for (int axis = 0; axis < 3; ++axis) array.items.push_back(numberJson(value[axis]));
  return add(key, std::move(array));
}

}  // namespace anamorph
