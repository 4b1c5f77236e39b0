// Preferences that last: a small JSON file in the user's configuration folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "panels/preferences.h"

namespace anamorph {

/// $XDG_CONFIG_HOME/anamorph/preferences.json, or the one below $HOME/.config.
std::filesystem::path preferencesPath();

/// What is not there, or makes no sense, has its default; `message` then says what is wrong with the file.
Preferences loadPreferences(const std::filesystem::path& path, std::string& message);

/// Makes the folder if needed and replaces the file atomically. Returns what could not be kept of the old one.
/// Throws Error.
std::vector<std::string> savePreferences(const std::filesystem::path& path, const Preferences& preferences);

const char* themeName(Theme theme);
std::optional<Theme> findTheme(const std::string& name);

}  // namespace anamorph
