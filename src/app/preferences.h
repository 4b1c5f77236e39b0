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

/// Puts what differs between `before` and `now` into the file, where another window may have written the rest, and
/// replaces it atomically. A file that cannot be read is replaced as a whole. Makes the folder. Returns what could not be
/// kept of the old one. Throws Error.
std::vector<std::string> savePreferences(const std::filesystem::path& path, const Preferences& before,
                                         const Preferences& now);

const char* themeName(Theme theme);
std::optional<Theme> findTheme(const std::string& name);

}  // namespace anamorph
