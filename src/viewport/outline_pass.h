// The orange line around what is selected: first where the thing is, alone and whole (a mask), then a line
// around that. So a thing is found even where another one hides it.
#pragma once

#include <map>
#include <string>

#include "gl/framebuffer.h"
#include "gl/shader.h"
#include "viewport/bands.h"
#include "viewport/piecework.h"
#include "viewport/scene_block.h"

namespace anamorph {

class OutlinePass {
 public:
  OutlinePass();

  /// Whether there is anything to outline.
  static bool wanted(const ViewportInput& input, const Visible& visible);

  /// The work of drawing it into `target`, over what is there. While it is done the textures of the meshes are bound
  /// (SurfaceStore) and the scene block is written: `scene`, its places relative to `origin`. `pixelScale`: pixels for
  /// one of the outline's width.
  void add(Piecework& work, const Framebuffer& target, const ViewportInput& input, const SceneBlock& scene,
           const Point& origin, const SurfaceSlots& slots, const Visible& visible, double pixelScale);

 private:
  void addMesh(Piecework& work, GpuSurface mesh, const SurfaceSlots& slots, const PixelRect& rect,
               const PixelSize& size);
  void addPlain(Piecework& work, const Selection& selection, const std::string& mirror, const Bands& bands);

  ShaderProgram mesh_, traced_, outline_;
  std::map<std::string, ShaderProgram> plain_;  // by the mirror's shape; made when needed
  Framebuffer mask_;
};

}  // namespace anamorph
