#include "viewport/outline_pass.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include <glad/gl.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "viewport/scene_program.h"
#include "viewport/surface_store.h"

namespace anamorph {
namespace {

constexpr double outlineWidth = 2.5;  // pixels at 100 %
constexpr int maskUnit = 4;

std::optional<GpuSurface> selectedMesh(const Selection& selection) {
  switch (selection.part) {
    case Part::original:
      return GpuSurface::original;
    case Part::sculpture:
      return GpuSurface::sculpture;
    case Part::eye:
      return GpuSurface::rtCamera;
    default:
      return std::nullopt;
  }
}

/// Of the selected thing, in scene coordinates.
Box selectedBox(const ViewportInput& input, const SceneBlock& scene, const SurfaceSlots& slots) {
  if (const auto mesh = selectedMesh(input.selection)) return slots[static_cast<int>(*mesh)].box;
  if (isOfMirror(input.selection)) return boxOf(input.level.optic.shape());
  const Point middle = input.level.lights[input.selection.index].position;
  const Vector radius(scene.sceneSize.z);
  return {middle - radius, middle + radius};
}

/// Where on the picture a box is seen, with a margin. The whole picture when some of it is behind the eye.
PixelRect seenRect(const Box& box, const SceneBlock& scene, const Point& origin, double margin) {
  const glm::vec2 size(scene.right.w, scene.up.w);
  const bool parallel = scene.forward.w > 0.5f;
  glm::vec2 low = size, high(0);
  for (int corner = 0; corner < 8; ++corner) {
    const Point p = box.corner(corner);
    const glm::vec3 v = glm::vec3(p - origin) - glm::vec3(scene.eye);
    const float depth = parallel ? 1 : glm::dot(v, glm::vec3(scene.forward));
    const glm::vec2 across(glm::dot(v, glm::vec3(scene.right)), glm::dot(v, glm::vec3(scene.up)));
    const glm::vec2 pixel = across / (scene.lens.x * depth) + 0.5f * size;
    const bool known = glm::all(glm::lessThan(glm::abs(pixel), glm::vec2(1e7f)));  // and a number
    if (!known || !(parallel || depth > 1e-3f * scene.sceneSize.x)) {
      return {0, 0, static_cast<int>(size.x), static_cast<int>(size.y)};
    }
    low = glm::min(low, pixel);
    high = glm::max(high, pixel);
  }
  // A tessellated mirror lies a little inside of the true one.
  const glm::vec2 wider = 0.01f * (high - low) + static_cast<float>(margin);
  low = glm::floor(glm::clamp(low - wider, glm::vec2(0), size));
  high = glm::ceil(glm::clamp(high + wider, glm::vec2(0), size));
  const glm::vec2 extent = glm::max(high - low, glm::vec2(0));
  return {static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(extent.x),
          static_cast<int>(extent.y)};
}

}  // namespace

OutlinePass::OutlinePass()
    : mesh_(makeSceneProgram("mesh.vert.glsl", "mask.frag.glsl")),
      traced_(makeSceneProgram("full_screen.vert.glsl", "traced_mask.frag.glsl")),
      outline_(makeSceneProgram("full_screen.vert.glsl", "outline.frag.glsl")) {
  outline_.use();
  outline_.set("mask", maskUnit);
}

bool OutlinePass::wanted(const ViewportInput& input, const Visible& visible) {
  const Selection& selection = input.selection;
  if (const auto mesh = selectedMesh(selection)) return visible.surface(*mesh);
  if (isOfMirror(selection)) return visible.hasMirror();
  return selection.part == Part::light && input.display.lightMarkers && selection.index >= 0 &&
         selection.index < std::min<int>(static_cast<int>(input.level.lights.size()), gpuLightLimit);
}

void OutlinePass::add(Piecework& work, const Framebuffer& target, const ViewportInput& input,
                      const SceneBlock& scene, const Point& origin, const SurfaceSlots& slots,
                      const Visible& visible, double pixelScale) {
  const PixelSize size{static_cast<int>(scene.right.w), static_cast<int>(scene.up.w)};
  addFramebuffer(work, mask_, size, {TexelFormat::r8}, false, true);
  work.add(1, [this](int, int) {
    mask_.bind();
    const GLfloat nothing[] = {0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, nothing);
  });
  const double width = outlineWidth * pixelScale;
  const PixelRect rect = seenRect(selectedBox(input, scene, slots), scene, origin, width + 2);
  const Bands bands(rect);
  if (const auto mesh = selectedMesh(input.selection)) {
    addMesh(work, *mesh, slots, rect, size);
  } else {
    addPlain(work, input.selection, visible.mirror, bands);
  }
  work.add(bands.count(), [this, &target, bands, width](int from, int to) {
    target.bind();
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    mask_.color().bind(maskUnit);
    outline_.use();
    outline_.set("width", static_cast<float>(width));
    bands.draw(from, to, drawFullScreen);
    glDisable(GL_BLEND);
  });
}

void OutlinePass::addMesh(Piecework& work, GpuSurface mesh, const SurfaceSlots& slots, const PixelRect& rect,
                          const PixelSize& size) {
  const int i = static_cast<int>(mesh), count = slots[i].triangles;
  const Bands bands(rect);
  if (count > 0 && fasterTraced(count, std::int64_t{size.width} * size.height)) {
    work.add(bands.count(), [this, i, bands](int from, int to) {
      mask_.bind();
      traced_.use();
      traced_.set("wanted", 1 << i);
      bands.draw(from, to, drawFullScreen);
    });
    return;
  }
  const ListPieces triangles = trianglePieces(count);
  work.add(triangles.count(), [this, i, bands, triangles](int from, int to) {
    mask_.bind();
    mesh_.use();
    mesh_.set("surface", i);
    bands.draw(0, bands.count(), [&] { drawTriangles(triangles, from, to); });
  });
}

void OutlinePass::addPlain(Piecework& work, const Selection& selection, const std::string& mirror,
                           const Bands& bands) {
  work.add(1, [this, mirror](int, int) {
    ShaderProgram& plain = plain_[mirror];
    if (plain.empty())
      plain = makeSceneProgram("full_screen.vert.glsl", "plain_mask.frag.glsl", sceneOptions(mirror));
  });
  const int light = selection.part == Part::light ? selection.index : -1;
  work.add(bands.count(), [this, mirror, light, bands](int from, int to) {
    mask_.bind();
    plain_[mirror].use();
    plain_[mirror].set("light", light);
    bands.draw(from, to, drawFullScreen);
  });
}

}  // namespace anamorph
