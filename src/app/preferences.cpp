#include "app/preferences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include "app/file_lock.h"
#include "base/error.h"
#include "base/file.h"
#include "base/folder.h"
#include "level/json_object.h"
#include "level/limits.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t maxBytes = std::size_t{1} << 20;
constexpr std::array<const char*, 3> themeNames{"dark", "light", "projector"};

void read(const JsonValue& object, const char* key, double& value, double min, double max) {
  const JsonValue* found = findMember(object, key);
  if (found && found->kind == JsonValue::Kind::number) value = std::clamp(found->number, min, max);
}

void read(const JsonValue& object, const char* key, bool& value) {
  const JsonValue* found = findMember(object, key);
  if (found && found->kind == JsonValue::Kind::boolean) value = found->text == "true";
}

JsonValue toJson(const Preferences& p) {
  return JsonObject()
      .add("theme", std::string(themeName(p.theme)))
      .add("language", p.language)
      .add("uiScale", p.uiScale)
      .add("vrtKeys", p.vrtKeys)
      .add("legend", p.legend)
      .add("tourSeen", p.tourSeen)
      .add("leftWidth", std::round(p.leftWidth))
      .add("rightWidth", std::round(p.rightWidth))
      .add("previewHeight", std::round(p.previewHeight))
      .value();
}

// What the file says, other programs' words too; an object without members where that is nothing.
JsonValue keptIn(const fs::path& path) {
  const JsonValue nothing{JsonValue::Kind::object, {}, 0, {}, {}};
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return nothing;
  try {
    const JsonValue kept = parseJson(readFile(path, maxBytes).view(), path.string());
    return kept.kind == JsonValue::Kind::object ? kept : nothing;
  } catch (const Error&) {
    return nothing;
  }
}

}  // namespace

fs::path preferencesPath() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  const fs::path base = config && *config ? fs::path(config) : homeFolder() / ".config";
  return base / "anamorph" / "preferences.json";
}

Preferences loadPreferences(const fs::path& path, std::string& message) {
  Preferences p;
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return p;
  try {
    const JsonValue json = parseJson(readFile(path, maxBytes).view(), path.string());
    if (const JsonValue* theme = findMember(json, "theme"); theme && theme->kind == JsonValue::Kind::string) {
      const auto found = findTheme(theme->text);
      if (!found) {
        message = fmt::format("{}: /theme: expected dark, light or projector, got {}", path.string(),
                              describeJson(*theme));
      }
      p.theme = found.value_or(p.theme);
    }
    if (const JsonValue* language = findMember(json, "language");
        language && language->kind == JsonValue::Kind::string) {
      p.language = language->text;
    }
    read(json, "uiScale", p.uiScale, 0, limits::uiScale.max);
    if (p.uiScale > 0) p.uiScale = std::max(p.uiScale, limits::uiScale.min);
    read(json, "vrtKeys", p.vrtKeys);
    read(json, "legend", p.legend);
    read(json, "tourSeen", p.tourSeen);
    read(json, "leftWidth", p.leftWidth, 180, 600);
    read(json, "rightWidth", p.rightWidth, 240, 900);
    read(json, "previewHeight", p.previewHeight, 220, 1400);
  } catch (const Error& error) {
    message = error.what();
  }
  return p;
}

std::vector<std::string> savePreferences(const fs::path& path, const Preferences& before,
                                         const Preferences& now) {
  makeFolder(path.parent_path());
  const SharedFileLock lock(path);
  JsonValue kept = keptIn(path);
  const JsonValue old = toJson(before), wanted = toJson(now);  // of the same keys
  for (std::size_t i = 0; i < wanted.keys.size(); ++i) {
    const auto there = std::find(kept.keys.begin(), kept.keys.end(), wanted.keys[i]);
    if (there == kept.keys.end()) {
      kept.keys.push_back(wanted.keys[i]);
      kept.items.push_back(wanted.items[i]);
    } else if (!(wanted.items[i] == old.items[i])) {
      kept.items[static_cast<std::size_t>(there - kept.keys.begin())] = wanted.items[i];
    }
  }
  return writeFile(path, formatJson(kept) + "\n");
}

const char* themeName(Theme theme) {
  return themeNames[static_cast<std::size_t>(theme)];
}

std::optional<Theme> findTheme(const std::string& name) {
  const auto found = std::find(themeNames.begin(), themeNames.end(), name);
  if (found == themeNames.end()) return std::nullopt;
  return static_cast<Theme>(found - themeNames.begin());
}

}  // namespace anamorph
