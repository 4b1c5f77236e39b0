// PNG files, through stb: encoded in memory and then written atomically, so a failed save never costs an
// older picture.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "raytrace/image.h"

namespace anamorph {

/// The bytes of a PNG file: 8 bits a channel, RGB or RGBA. Throws Error when the picture is over the format's
/// limit here (2^30 bytes).
std::string encodePng(const Bitmap& bitmap);

/// Writes the picture as PNG; replaces the file atomically. Returns what could not be kept of the file that was replaced. Throws
/// Error.
std::vector<std::string> savePng(const std::filesystem::path& path, const Bitmap& bitmap);
std::vector<std::string> savePng(const std::filesystem::path& path, const Image& image);

/// Reads a PNG as RGB or RGBA, whichever it has (grey becomes RGB). Throws Error.
Bitmap loadPng(const std::filesystem::path& path);

}  // namespace anamorph
