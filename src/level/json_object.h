// JSON to be written, built member by member.
#pragma once

#include <string>
#include <vector>

#include "level/json.h"
#include "math/vec.h"

namespace anamorph {

/// An array that items are to be put into.
JsonValue emptyList();
/// An array of strings.
JsonValue textList(const std::vector<std::string>& texts);

/// A JSON object built member by member. Numbers that are not finite become null.
class JsonObject {
 public:
  JsonObject& add(const std::string& key, JsonValue value);
  JsonObject& add(const std::string& key, double value);
  JsonObject& add(const std::string& key, std::size_t value);
  JsonObject& add(const std::string& key, bool value);
  JsonObject& add(const std::string& key, const std::string& value);
  JsonObject& add(const std::string& key, const Vector& value);
  const JsonValue& value() const { return value_; }

 private:
  JsonValue value_{JsonValue::Kind::object, {}, 0, {}, {}};
};

}  // namespace anamorph
