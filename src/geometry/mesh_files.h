// Mesh files: OBJ, STL and PLY, in and out. Written is the format of the file's ending; read is what the file is,
// whatever its ending. A mesh that other programs open is opened: what of it cannot be used is left out, counted and
// said in a warning. Reading trusts nothing, though: whatever the bytes are, the result is a valid mesh or an Error
// that says where the file is wrong, and no memory is taken for what a header merely claims. The readers and writers
// themselves are in obj_, stl_ and ply_reader.h and _writer.h.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh.h"
#include "geometry/mesh_limits.h"
#include "geometry/smooth_mesh.h"
#include "geometry/up_guess.h"

namespace anamorph {

/// A mesh as its file has it, and what was to be said about the file: whole sentences, `file: where: how many of what`.
struct LoadedMesh {
  Mesh mesh;
  std::vector<std::string> warnings;
  UpGuess up = {};
};

/// Reads positions and faces; polygons are triangulated (concave ones too), negative indices resolved,
/// texture coordinates, normals and materials skipped. Vertices keep the file's order, but those that no face uses
/// are left out; those of an STL file, which has no indices, are welded. At least one triangle, all coordinates finite
/// and of magnitude <= 1e9. Throws Error `file: where: expected, got` when no triangle is left, when the file is cut
/// off, and when it is larger than the limits; Cancelled as readFile does.
LoadedMesh loadMesh(const std::filesystem::path& path, const MeshLimits& limits = {},
                    const CancelToken* token = nullptr);

/// The same from a file's bytes; `name` is the file's name, with which messages begin.
LoadedMesh readMesh(std::string_view bytes, const std::string& name, const MeshLimits& limits = {});

/// A surface as its file has it: with the normals of an OBJ file, else with those of its faces.
struct LoadedSurface {
  SmoothMesh surface;
  std::vector<std::string> warnings;
};

/// As loadMesh, for a surface that reflects.
LoadedSurface loadSurface(const std::filesystem::path& path, const MeshLimits& limits = {},
                          const CancelToken* token = nullptr);

/// Whether loadMesh and saveMesh know the ending: .obj, .stl, .ply, in small or capital letters.
bool isMeshFile(const std::filesystem::path& path);

/// Whether a file is meant as a model: by its ending or, where that says nothing, by its first bytes. loadMesh opens
/// it, or says what else it is.
bool isModelFile(const std::filesystem::path& path);

/// What a model is that loadMesh does not open, and what to do: "STEP is not read; export it as STL or OBJ". Empty for
/// an OBJ, STL or PLY, and for what is no model at all.
std::string foreignFormatOf(const std::filesystem::path& path);

/// Optional extras of an export.
struct MeshFileOptions {
  double scale = 1;     ///< positions are multiplied by it (millimetres per scene unit)
  std::string comment;  ///< one line at the head of the file, without line breaks
};

/// Replaces the file atomically, in the format its ending says: OBJ (numbers are the shortest that read back
/// to the same double), binary STL (float), binary little-endian PLY (double). Meshes without triangles are
/// allowed in OBJ and PLY. Returns what could not be kept of the file that was replaced. Throws Error.
std::vector<std::string> saveMesh(const std::filesystem::path& path, const Mesh& mesh,
                                  const MeshFileOptions& options = {});

}  // namespace anamorph
