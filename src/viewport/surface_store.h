// The graphics card's copies of the meshes: what rays and triangles need of them, in four textures
// (shaders/bvh.glsl). Copies follow pointers: another pointer, another upload; what keeps its pointer stays.
// While a mesh only moves, its triangles are not sent again. What is sent goes in pieces (piecework.h).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "gl/texture.h"
#include "viewport/piecework.h"
#include "viewport/scene_block.h"

namespace anamorph {

/// A mesh to be copied; null pointers: there is none.
struct SurfaceSource {
  PreparedMesh prepared;
  std::shared_ptr<const Sculpture> sculpture;  ///< for the status of its vertices; null: all are usable
  std::shared_ptr<const std::vector<float>> borders{};  ///< of a mirror, a fraction for every normal; null: 0

  bool operator==(const SurfaceSource&) const = default;
};
using SurfaceSources = std::array<SurfaceSource, gpuSurfaceCount>;

/// Texture units that the textures are read at.
struct SurfaceUnits {
  static constexpr int nodes = 0, positions = 1, triangles = 2, normals = 3;
};

/// Whether the triangles that pixels see are found sooner by a ray for every pixel than by drawing all
/// triangles. Graphics processors draw small triangles faster than they trace; the main processor takes about
/// as long for one as for a ray.
bool fasterTraced(std::int64_t triangles, std::int64_t pixels);

class SurfaceStore {
 public:
  SurfaceStore();

  /// slots() are of these from now on; the work of uploading what has changed has to be done before they are drawn. An
  /// earlier work that was not finished has to be forgotten.
  void update(const SurfaceSources& sources, Piecework& work);
  /// Texture units are left to it; the work binds what it makes anew.
  void bind() const;

  const SurfaceSlots& slots() const { return slots_; }
  /// Which meshes are left out because the graphics card's textures are too small for them; empty: none.
  std::string problem() const;

 private:
  static constexpr int arrayCount = 4;
  using Lengths = std::array<std::array<std::size_t, gpuSurfaceCount>, arrayCount>;

  void leaveOutWhatDoesNotFit(SurfaceSources& sources, Lengths& lengths);
  void slot(int i, const SurfaceSource& source);
  void addUpload(Piecework& work, int array, int i, std::size_t texels);
  void upload(int array, int i, std::size_t from, std::size_t to);

  std::array<TexelArrays, arrayCount> arrays_;  // in the order of SurfaceUnits
  SurfaceSources sources_;
  std::array<std::array<bool, gpuSurfaceCount>, arrayCount>
      missing_{};  // of the sources: is not all uploaded
  SurfaceSlots slots_;
  std::vector<int> leftOut_;
};

}  // namespace anamorph
