#include "viewport/scene_block.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/ext/vector_double4.hpp>

#include "edit/camera_body.h"
#include "math/palette.h"
#include "raytrace/scene.h"
#include "raytrace/tracer.h"

namespace anamorph {
namespace {

constexpr Material rtCameraMaterial{Color(0.055, 0.06, 0.07), 0.5, 0.9, 0.35, 30};
constexpr double markerRadius = 0.018;  // in radii of the scene

glm::vec4 pack(const Vector& v, double w = 0) {
  return glm::vec4(glm::dvec4(v, w));
}

std::array<glm::vec4, 2> pack(const Material& m) {
  return {pack(m.color, m.ambient), glm::vec4(glm::dvec4(m.diffuse, m.specular, m.shininess, 0))};
}

/// A pose that can be computed with, whatever was asked for.
ViewPose sound(ViewPose pose) {
  const bool finite = isFinite(pose.eye) && isFinite(pose.target) && isFinite(pose.up) &&
                      lengthSquared(pose.target - pose.eye) < 1e30 && std::isfinite(pose.fovDegrees);
  if (!finite) return {};
  if (!(lengthSquared(pose.up) > 0)) pose.up = {0, 0, 1};
  pose.fovDegrees = std::clamp(pose.fovDegrees, 0.01, 179.0);
  return pose;
}

void packView(SceneBlock& block, const ViewportInput& input, const Point& origin, int width, int height,
              const Pixel& shift) {
  const ViewProjection view(sound(input.pose), width, height);
  block.eye = pack(view.eye() - origin);
  block.right = pack(view.frame().right, width);
  block.up = pack(view.frame().up, height);
  block.forward = pack(view.frame().forward, view.orthographic());
  block.lens = glm::vec4(glm::dvec4(2 * view.halfHeight() / height, shift.x, shift.y, 0));
}

/// As near to the meshes as can be, so that the depth buffer tells their triangles apart.
void packDepths(SceneBlock& block, const ViewportInput& input, const SceneMeasure& measure,
                const SurfaceSlots& slots, const Visible& visible) {
  const ViewPose pose = sound(input.pose);
  const ViewProjection view(pose, 1, 1);
  double near = std::numeric_limits<double>::infinity(), far = 0;
  for (int i = 0; i < gpuSurfaceCount; ++i) {
    if (!visible.surface(static_cast<GpuSurface>(i))) continue;
    for (int corner = 0; corner < 8; ++corner) {
      const Box& box = slots[i].box;
      const Point p = box.corner(corner);
      const double depth = glm::dot(p - view.eye(), view.frame().forward);
      near = std::min(near, depth);
      far = std::max(far, depth);
    }
  }
  far = std::max(1.01 * far, 1e-3 * measure.radius);
  near = std::clamp(0.99 * near, view.orthographic() ? 0.0 : 1e-3 * far, 0.9 * far);
  const double unit = 1e-3 * measure.radius;
  const double end = glm::length(view.eye() - measure.centre) + 100 * measure.radius;
  block.depthRange = glm::vec4(glm::dvec4(near, far, 1 / unit, 1 / std::log2(1 + end / unit)));
}

void packSurroundings(SceneBlock& block, const ViewportInput& input, const SceneMeasure& measure) {
  const LevelScene& level = input.level;
  const Background& background = input.display.background ? *input.display.background : level.background;
  const Ground ground;
  const Vector cells = measure.centre / ground.gridSpacing;
  block.sceneSize = glm::vec4(glm::dvec4(measure.radius, measure.epsilon, markerRadius * measure.radius, 0));
  block.backgroundTop = pack(background.top, input.transparent);
  block.backgroundBottom = pack(background.bottom);
  block.ground = glm::vec4(glm::dvec4(level.ground.height - measure.centre.z, ground.gridSpacing,
                                      ground.gridSpacing * (cells.x - std::floor(cells.x)),
                                      ground.gridSpacing * (cells.y - std::floor(cells.y))));
  block.groundLook = pack(ground.material);
}

int packLights(SceneBlock& block, const LevelScene& level, const Point& origin) {
  int count = 0;
  for (const PointLight& light : level.lights) {
    if (count == gpuLightLimit) break;
    block.lightPosition[count] = pack(isFinite(light.position) ? light.position - origin : Point(0));
    block.lightColor[count] = pack(light.intensity * light.color);
    ++count;
  }
  return count;
}

void packSurfaces(SceneBlock& block, const ViewportInput& input, const Visible& visible,
                  const SurfaceSlots& slots, const Point& origin) {
  const DisplaySettings& display = input.display;
  Material sculpture = input.level.sculpture.material;
  if (display.statusColors) sculpture.color = lightOf(palette::vertexStatus[0]);
  const Material* materials[] = {&sculpture, &input.level.original.material, &rtCameraMaterial};
  const bool solidOriginal = visible.original && !visible.ghost;
  const bool mirroredOriginal = visible.original && display.originalInMirror;
  using F = SurfaceFlags;
  const int flags[] = {
      visible.sculpture * (F::inMirror | F::castsShadow | F::castsInMirror) | visible.wires * F::hasWires,
      mirroredOriginal * F::inMirror | solidOriginal * F::castsShadow |
          (solidOriginal && mirroredOriginal) * F::castsInMirror,
      visible.rtCamera * F::inMirror, 0};
  for (int i = 0; i < gpuMeshCount; ++i) {
    const auto packed = pack(*materials[i]);
    std::copy(packed.begin(), packed.end(), &block.materials[2 * i]);
  }
  for (int i = 0; i < gpuSurfaceCount; ++i) {
    const SurfaceSlot& slot = slots[i];
    const bool there = slot.triangles > 0;
    block.surfaceCentre[i] = pack(slot.centre - origin, slot.radius);
    block.surfaceLow[i] = pack(there ? slot.box.min - origin : Vector(0));
    block.surfaceHigh[i] = pack(there ? slot.box.max - origin : Vector(0));
    block.surfaceOffsets[i] = slot.first;
    block.surfaceSize[i] = {slot.triangles, there ? flags[i] | slot.whole * F::wholeMesh : 0, slot.root, 0};
  }
}

// In sizes of the mirror, so that the distance from a plane is a share of it, as borders are told.
int packClips(SceneBlock& block, const Shape& mirror, const Point& origin) {
  if (mirror.clip().empty()) return 0;
  const double size = boxOf(mirror).diagonal();
  std::size_t count = 0;
  for (const HalfSpace& half : mirror.clip()) {
    if (count == block.mirrorClip.size()) break;
    const Vector normal = glm::normalize(half.normal) / size;
    block.mirrorClip[count++] = pack(normal, glm::dot(normal, half.point - origin));
  }
  return static_cast<int>(count);
}

void packScreen(SceneBlock& block, const ViewportInput& input, const Point& origin) {
  const Camera& camera = input.level.camera;
  const PixelGrid& grid = input.level.grid;
  const Projection projection(camera, std::max(grid.columns, 1), std::max(grid.rows, 1));
  const Frame& frame = projection.frame();
  const double height = 2 * grid.distance * std::tan(radians(camera.fovDegrees) / 2);
  const double width = height * projection.width() / projection.height();
  const Point middle = camera.eye + grid.distance * frame.forward;
  block.screenCorner = pack(middle - 0.5 * width * frame.right + 0.5 * height * frame.up - origin,
                            std::clamp(input.display.screenOpacity, 0.0, 1.0));
  block.screenRight = pack(width * frame.right, projection.width());
  block.screenDown = pack(-height * frame.up, projection.height());
}

}  // namespace

bool Visible::surface(GpuSurface which) const {
  switch (which) {
    case GpuSurface::sculpture:
      return sculpture;
    case GpuSurface::original:
      return original;
    case GpuSurface::rtCamera:
      return rtCamera;
    case GpuSurface::mirror:
      break;
  }
  return false;  // it is met by rays only
}

ShaderKinds shaderKindsOf(const ViewportInput& input) {
  const DisplaySettings& display = input.display;
  return {display.mirror && isShown(input.level.optic) ? shaderOf(input.level.optic.shape())
                                                       : ShaderKinds::noMirror,
          display.originalLook == OriginalLook::ghost, display.sculpture && display.wireframe};
}

Visible findVisible(const ViewportInput& input, const SurfaceSlots& slots, double sceneRadius) {
  const DisplaySettings& display = input.display;
  const Camera& camera = input.level.camera;
  const auto there = [&](GpuSurface which) { return slots[static_cast<int>(which)].triangles > 0; };
  Visible visible;
  visible.sculpture = display.sculpture && there(GpuSurface::sculpture);
  visible.original = display.originalLook != OriginalLook::hidden && there(GpuSurface::original);
  static_cast<ShaderKinds&>(visible) = shaderKindsOf(input);
  const bool outside =
      glm::length(input.pose.eye - camera.eye) > 1.5 * rtCameraSize(input.level.grid, sceneRadius);
  const bool shown = display.rtCamera && outside && isFinite(camera.eye) && isFinite(camera.target);
  visible.rtCamera = shown && there(GpuSurface::rtCamera);
  visible.screen = shown && display.screenOpacity > 0 && input.level.grid.distance > 0 && input.screen &&
                   !input.screen->pixels.empty();
  return visible;
}

SceneBlock makeSceneBlock(const ViewportInput& input, const SceneMeasure& measure, const SurfaceSlots& slots,
                          const Visible& visible, int width, int height, const Pixel& shift) {
  SceneBlock block{};
  const LevelScene& level = input.level;
  packView(block, input, measure.centre, width, height, shift);
  packDepths(block, input, measure, slots, visible);
  packSurroundings(block, input, measure);
  packSurfaces(block, input, visible, slots, measure.centre);
  if (visible.screen) packScreen(block, input, measure.centre);
  int clips = 0;
  if (visible.hasMirror()) {
    const PackedShape shape = level.optic.shape()->packed(measure.centre);
    std::copy(shape.begin(), shape.end(), block.mirrorShape.begin());
    clips = packClips(block, level.optic.shape(), measure.centre);
  }
  block.mirrorTint = pack(level.mirrorLook.reflectance * level.mirrorLook.tint);
  const int lights = packLights(block, level, measure.centre);
  block.counts = {lights, std::clamp(level.tracing.maxDepth, 0, maxTraceDepth), 0,
                  level.ground.visible && !input.transparent};
  block.options = {level.tracing.shadows, input.display.lightMarkers, clips, 0};
  return block;
}

}  // namespace anamorph
