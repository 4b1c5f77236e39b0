// Results as JSON objects and as lines for people.
#pragma once

#include <string>

#include "anamorphosis/match.h"
#include "level/json.h"

namespace anamorph {

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

/// {"mapped": 6146, "missesMirror": 0, ...}
JsonValue statusJson(const StatusCounts& counts);

/// {"size": ..., "silhouetteIou": ..., ...}; correspondencePx is null when no pixel could be compared.
JsonValue matchJson(const MatchReport& report, const StatusCounts& counts);

/// Object on stdout, indented.
void printJson(const JsonValue& value);

}  // namespace anamorph
