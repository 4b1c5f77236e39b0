// Pictures on the graphics card that panels show; whoever draws the window makes them.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace anamorph {

/// A picture on the graphics card; id 0: none.
struct UiTexture {
  std::uint32_t id = 0;
  int width = 0, height = 0;
  bool bottomUp = false;  ///< its first row is the lowest, as OpenGL draws
};

struct UiTextures {
  UiTexture view;
  UiTexture reflection, original, difference;
  UiTexture render;                             ///< the high-resolution picture
  std::map<std::string, UiTexture> thumbnails;  ///< by the level's name
};

}  // namespace anamorph
