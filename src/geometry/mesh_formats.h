// Which of the mesh formats a file is of: by its ending, and, because endings are wrong, by its content.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string_view>

namespace anamorph {

enum class MeshFormat { obj, stl, ply };

/// "an OBJ"
std::string_view nameOf(MeshFormat format);

/// Of .obj, .stl and .ply, in small or capital letters; nothing for another ending.
std::optional<MeshFormat> formatByEnding(const std::filesystem::path& path);

/// The format that the first bytes of a file are of beyond doubt. 64 KiB tell it, or all of a smaller file.
std::optional<MeshFormat> formatByContent(std::string_view head, std::size_t fileSize);

}  // namespace anamorph
