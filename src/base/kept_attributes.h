// A file that takes another one's place looks like it: access rights, owner, group, extended attributes and with
// them the access control list. What belongs to the old contents is not kept: setuid, setgid, and what the system
// itself says about a file (attributes that begin with "security.").
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace anamorph {

/// Gives the open file what the one at `old` has; nothing where there is none. Returns what could not be kept, and
/// which other names (hard links) keep the old contents, as messages that begin with `name`. Never throws Error.
std::vector<std::string> keepAttributes(const std::filesystem::path& old, int file, const std::string& name);

}  // namespace anamorph
