// Mesh files: OBJ, STL and PLY, in and out. The format is chosen by the file's ending. Reading trusts
// nothing: whatever the bytes are, the result is a valid mesh or an Error that says where the file is wrong,
// and no memory is taken for what a header merely claims. The readers and writers themselves are in obj_,
// stl_ and ply_reader.h and _writer.h.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/progress.h"
#include "geometry/mesh.h"
#include "geometry/mesh_limits.h"

namespace anamorph {

/// Reads positions and faces; polygons are triangulated (concave ones too), negative indices resolved,
/// texture coordinates, normals and materials skipped. Vertices keep the file's order, unused ones included;
/// those of an STL file, which has no indices, are welded. At least one triangle, all coordinates finite and
/// of magnitude <= 1e9. Throws Error `file: where: expected, got`, and Cancelled as readFile does.
Mesh loadMesh(const std::filesystem::path& path, const MeshLimits& limits = {},
              const CancelToken* token = nullptr);

/// The same from a file's bytes; `name` is the file's name: its ending says the format, messages begin with
/// it.
Mesh readMesh(std::string_view bytes, const std::string& name, const MeshLimits& limits = {});

/// The same for bytes without a file's name, from standard input: what they begin with says the format, and what is
/// neither PLY nor STL is taken for OBJ.
Mesh readMeshByContent(std::string_view bytes, const std::string& name, const MeshLimits& limits = {});

/// Whether loadMesh and saveMesh know the ending: .obj, .stl, .ply, in small or capital letters.
bool isMeshFile(const std::filesystem::path& path);

/// Optional extras of an export.
struct MeshFileOptions {
  double scale = 1;     ///< positions are multiplied by it (millimetres per scene unit)
  std::string comment;  ///< one line at the head of the file, without line breaks
};

/// Replaces the file atomically, in the format its ending says: OBJ (numbers are the shortest that read back
/// to the same double), binary STL (float), binary little-endian PLY (double). Meshes without triangles are
/// allowed in OBJ and PLY. Throws Error.
void saveMesh(const std::filesystem::path& path, const Mesh& mesh, const MeshFileOptions& options = {});

}  // namespace anamorph
