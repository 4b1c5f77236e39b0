// How large a mesh that is read may be. Readers ask before they take memory, so that a file cannot claim more
// than a machine has.
#pragma once

#include <cstddef>
#include <string>

namespace anamorph {

/// Checked before memory is taken. The defaults are far above what the program can show.
struct MeshLimits {
  std::size_t maxBytes = std::size_t{2} << 30;
  std::size_t maxVertices = 50'000'000;

  /// How to raise maxBytes, for messages.
  static constexpr const char* bytesHelp = "--max-mesh-mb raises the limit";

  /// A closed surface has twice as many triangles as vertices.
  std::size_t maxTriangles() const { return 2 * maxVertices; }

  /// The message of the Error.
  std::string tooManyTriangles() const;
};

}  // namespace anamorph
