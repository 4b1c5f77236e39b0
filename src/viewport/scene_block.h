// What every pass needs to know of the scene, as the shaders read it: shaders/scene.glsl has the same fields
// in the same order. Made from the input by a pure function; only here do doubles become floats.
//
// Places are relative to `origin`, the middle of what is lit.
#pragma once

#include <array>
#include <cstdint>

#include <string>

#include <glm/vec4.hpp>

#include "level/limits.h"
#include "math/palette.h"
#include "optics/optic.h"
#include "raytrace/scene.h"
#include "viewport/viewport_input.h"

namespace anamorph {

constexpr int gpuMeshCount = 3;  ///< that are drawn and lit
constexpr int gpuSurfaceCount = gpuMeshCount + 1;
constexpr int gpuLightLimit = 16;
/// Pieces of the mirror that are cut away one behind the other on a ray, after which it meets no mirror: a loop of
/// shaders needs an end. The tracer has no such bound; a quadric has two pieces on a ray, only a spline of many waves or
/// a mesh can have more than this.
constexpr int gpuLayerLimit = 8;
constexpr int sceneBlockPoint = 0;  ///< where programs find the block

/// Which surface is which in the shaders. The mirror is one when its triangles are traced (tessellatedShader).
enum class GpuSurface { sculpture = 0, original = 1, rtCamera = 2, mirror = 3 };

/// What a surface does in the shaders; any of them together.
struct SurfaceFlags {
  static constexpr int inMirror = 1;       ///< the mirror shows it,
  static constexpr int castsShadow = 2;    ///< it takes light from what is seen directly,
  static constexpr int castsInMirror = 4;  ///< and from what is seen in the mirror,
  static constexpr int hasWires = 8;       ///< its triangles' edges are drawn
  static constexpr int wholeMesh = 16;     ///< every vertex is usable
};

/// How the style and the flags of a line are told to its shader, in one number.
struct LineFlags {
  static constexpr int styleMask = 3, arrow = 4, inFront = 8;
};

/// Every field is a multiple of 16 bytes, so that std140 and C++ agree.
struct SceneBlock {
  glm::vec4 eye, right, up, forward, lens, depthRange;
  glm::vec4 sceneSize, backgroundTop, backgroundBottom, ground;
  std::array<glm::vec4, 2> groundLook;
  std::array<glm::vec4, shapeVectors> mirrorShape;
  std::array<glm::vec4, limits::mostClips> mirrorClip;
  glm::vec4 mirrorTint;
  std::array<glm::vec4, gpuSurfaceCount> surfaceCentre, surfaceLow, surfaceHigh;
  std::array<glm::vec4, 2 * gpuMeshCount> materials;
  std::array<glm::vec4, gpuLightLimit> lightPosition, lightColor;
  glm::vec4 screenCorner, screenRight, screenDown;
  glm::ivec4 counts, options;
  std::array<glm::ivec4, gpuSurfaceCount> surfaceOffsets, surfaceSize;
};
static_assert(sizeof(SceneBlock) % 16 == 0);

/// Where a surface is in the textures, and its box.
struct SurfaceSlot {
  glm::ivec4 first{0};  ///< node, triangle, vertex, normal
  int triangles = 0;    ///< 0: there is none
  int root = 0;         ///< link and count of the root node, 8 * link + count
  bool whole = true;    ///< every vertex is usable
  Point centre{0};
  double radius = 0;
  Box box;  ///< of its vertices
};
using SurfaceSlots = std::array<SurfaceSlot, gpuSurfaceCount>;

/// The colour that the status of a vertex is drawn in.
inline Color statusInk(PathStatus status) {
  return inkOf(palette::vertexStatus[static_cast<std::size_t>(status)]);
}

/// What the slowest shaders are made for (shaders/scene_pass.frag.glsl). They are the same whether a mesh is there yet or
/// not, so that a level that is being opened needs no others than when it is.
struct ShaderKinds {
  std::string mirror = noMirror;  ///< the file of shaders/shapes that is its shape
  bool ghost = false, wires = false;

  static constexpr const char* noMirror = "none";
  bool hasMirror() const { return mirror != noMirror; }
  auto operator<=>(const ShaderKinds&) const = default;
};
ShaderKinds shaderKindsOf(const ViewportInput& input);

/// What is drawn of the input, decided once for all passes.
struct Visible : ShaderKinds {
  bool sculpture = false;
  bool original = false;  ///< solid or ghost
  bool rtCamera = false;
  bool screen = false;
  bool surface(GpuSurface which) const;
};
Visible findVisible(const ViewportInput& input, const SurfaceSlots& slots, double sceneRadius);

/// For a picture of width x height pixels, whose size may differ from the input's; `shift` moves the sample
/// away from the middles of the pixels, right and up.
SceneBlock makeSceneBlock(const ViewportInput& input, const SceneMeasure& measure, const SurfaceSlots& slots,
                          const Visible& visible, int width, int height, const Pixel& shift);

}  // namespace anamorph
