// The orange line around what is selected: first where the thing is, alone and whole (a mask), then a line
// around that. So a thing is found even where another one hides it.
#pragma once

#include <map>
#include <string>

#include "gl/framebuffer.h"
#include "gl/shader.h"
#include "viewport/scene_block.h"

namespace anamorph {

class OutlinePass {
 public:
  OutlinePass();

  /// Whether there is anything to outline.
  static bool wanted(const ViewportInput& input, const Visible& visible);

  /// Into `target`, over what is there. The textures of the meshes are bound (SurfaceStore), `scene` is
  /// written, its places relative to `origin`. `pixelScale`: pixels for one of the outline's width.
  void draw(const Framebuffer& target, const ViewportInput& input, const SceneBlock& scene,
            const Point& origin, const SurfaceSlots& slots, const Visible& visible, double pixelScale);

 private:
  ShaderProgram mesh_, traced_, outline_;
  std::map<std::string, ShaderProgram> plain_;  // by the mirror's shape; made when needed
  Framebuffer mask_;
};

}  // namespace anamorph
