#include "viewport/outline_view.h"

#include <algorithm>
#include <optional>

#include <glad/gl.h>

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

}  // namespace

OutlineView::OutlineView()
    : mesh_("mesh.vert.glsl", "mask.frag.glsl"),
      plain_("full_screen.vert.glsl", "plain_mask.frag.glsl"),
      outline_("full_screen.vert.glsl", "outline.frag.glsl") {
  for (const ShaderProgram* program : {&mesh_, &plain_}) {
    program->use();
    program->bindBlock("Scene", 0);
    program->set("nodes", SurfaceUnits::nodes);
    program->set("positions", SurfaceUnits::positions);
    program->set("triangles", SurfaceUnits::triangles);
    program->set("normals", SurfaceUnits::normals);
  }
  outline_.use();
  outline_.set("mask", maskUnit);
}

bool OutlineView::wanted(const ViewportInput& input, const Visible& visible) {
  const Selection& selection = input.selection;
  if (const auto mesh = selectedMesh(selection)) return visible.surface(*mesh);
  if (selection.part == Part::mirror) return visible.mirror;
  return selection.part == Part::light && input.display.lightMarkers && selection.index >= 0 &&
         selection.index < std::min<int>(static_cast<int>(input.level.lights.size()), gpuLightLimit);
}

void OutlineView::draw(const Framebuffer& target, const ViewportInput& input, const SurfacePlaces& places,
                       double pixelScale) {
  if (mask_.width() != target.width() || mask_.height() != target.height()) {
    mask_ = Framebuffer();
    mask_ = Framebuffer(target.width(), target.height(), {TexelFormat::r8}, false, true);
  }
  mask_.bind();
  glDisable(GL_BLEND);
  const GLfloat nothing[] = {0, 0, 0, 0};
  glClearBufferfv(GL_COLOR, 0, nothing);
  if (const auto mesh = selectedMesh(input.selection)) {
    mesh_.use();
    mesh_.set("surface", static_cast<int>(*mesh));
    glDrawArrays(GL_TRIANGLES, 0, 3 * places[static_cast<int>(*mesh)].triangles);
  } else {
    plain_.use();
    plain_.set("light", input.selection.part == Part::light ? input.selection.index : -1);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  target.bind();
  glEnable(GL_BLEND);
  mask_.color().bind(maskUnit);
  outline_.use();
  outline_.set("width", static_cast<float>(outlineWidth * pixelScale));
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace anamorph
