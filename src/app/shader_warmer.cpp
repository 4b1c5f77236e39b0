#include "app/shader_warmer.h"

#include <exception>

#include "geometry/shapes.h"
#include "gl/offscreen_context.h"
#include "viewport/viewport.h"

namespace anamorph {
namespace {

constexpr int side = 9;  // pixels of the tiny picture: no power of two, as sizes of windows seldom are

PreparedMesh box(int segments) {
  return prepareMesh(std::make_shared<const Mesh>(makeBox(Vector(1), segments)));
}

// Meshes of few and of many triangles for so few pixels are drawn in two ways (fasterTraced()), things that are
// selected in two (outline_pass.h), and the second sample is added to the first by a shader, too.
void drawTiny(ViewportInput input) {
  const OffscreenContext context(GlKind::desktop, OffscreenContext::Functions::loaded);
  Viewport viewport;
  input.width = input.height = side;
  input.pose = {Point(3, -4, 2), Point(0), Direction(0, 0, 1)};
  input.lines = std::make_shared<const std::vector<Line>>(1, Line{Point(-1), Point(1)});
  input.screen = nullptr;
  for (const int segments : {1, 6}) {
    input.original = box(segments);
    input.sculpture = {nullptr, input.original};
    for (const Part part : {Part::sculpture, Part::mirror}) {
      input.selection = {part, 0};
      viewport.draw(input, 1, 3, 3);
    }
  }
}

}  // namespace

bool ShaderWarmer::ready(const ViewportInput& input) {
  if (const auto done = done_->take()) warm_.insert(*done);
  const ShaderKinds kinds = shaderKindsOf(input);
  if (warm_.count(kinds) != 0) return true;
  if (warming_ && warm_.count(*warming_) == 0) return false;  // one after the other
  warming_ = kinds;
  worker_.request([input, kinds, done = done_](const Progress&) {
    try {
      drawTiny(input);
    } catch (const std::exception&) {
      // No second context here, or no memory: then the view compiles them itself.
    }
    done->put(kinds);
  });
  return false;
}

}  // namespace anamorph
