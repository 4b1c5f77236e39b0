// The high-resolution picture: size and samples, progress, zoom, save.
#pragma once

#include <filesystem>
#include <string>

#include "panels/browser_state.h"
#include "panels/look.h"
#include "panels/requests.h"
#include "panels/textures.h"

namespace anamorph {

struct RenderDialog {
  bool open = false;
  int longerSide = 1024;
  int samplesPerAxis = 3;
  bool running = false;
  double fraction = 0;
  std::string saving;  ///< the file that a picture is being saved to; empty: none
  float zoom = 1;
  float panX = 0, panY = 0;
  std::filesystem::path folder;  ///< of the last picture saved; empty: none yet
  bool choosing = false;         ///< the file browser is open for it
  std::string message;
};

/// `image`: the picture as it is now; `level`: the file whose name the picture's is made of, may be empty.
void drawRenderWindow(RenderDialog& dialog, const UiTexture& image, const std::filesystem::path& level,
                      FileBrowser& browser, UiRequests& requests, const Look& look);

}  // namespace anamorph
