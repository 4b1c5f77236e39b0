// The head of a PLY file: which elements follow, how many of each, and of which properties their rows are
// made. After Greg Turk's "The PLY Polygon File Format" (1994).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh_remarks.h"

namespace anamorph {

enum class PlyFormat { ascii, binaryLittleEndian, binaryBigEndian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// The bytes of one binary value.
std::size_t sizeOf(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> countType = std::nullopt;  ///< set for a list: its length comes first, as this type
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;  ///< what the file claims
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< where the data begins
};

/// Its lines end in \n, \r\n or \r; lines of unknown keywords are remarked and skipped. Throws Error with the line for
/// a head that is not understood or has no end.
PlyHeader readPlyHeader(std::string_view bytes, MeshRemarks& remarks);

}  // namespace anamorph
