// What must hold for any bytes: reading them gives a valid mesh or an Error with a message, nothing else.
// Shared by the fuzz targets and by the short regression over their corpus (geometry/fuzz_corpus_test.cpp).
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "base/check.h"
#include "base/error.h"
#include "geometry/mesh_files.h"

namespace anamorph::testing {

inline void checkMesh(const Mesh& mesh) {
  CHECK(!mesh.triangles.empty());
  CHECK(mesh.positions.x.size() == mesh.positions.y.size() &&
        mesh.positions.x.size() == mesh.positions.z.size());
  for (const Triangle& t : mesh.triangles) {
    CHECK(*std::max_element(t.begin(), t.end()) < mesh.positions.size());
    CHECK(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
  }
  for (const auto* axis : {&mesh.positions.x, &mesh.positions.y, &mesh.positions.z}) {
    // A NaN fails too.
    CHECK(
        std::all_of(axis->begin(), axis->end(), [](double value) { return value >= -1e9 && value <= 1e9; }));
  }
}

/// Whether the bytes are a mesh; `name` says the format. Throws ProgrammingError when they are neither mesh
/// nor Error.
inline bool readsAsMesh(std::string_view bytes, const std::string& name) {
  try {
    checkMesh(readMesh(bytes, name, {.maxBytes = 1 << 20, .maxVertices = 100'000}).mesh);
    return true;
  } catch (const Error& error) {
    CHECK(!error.message.empty() && error.file == name);
    return false;
  }
}

}  // namespace anamorph::testing
