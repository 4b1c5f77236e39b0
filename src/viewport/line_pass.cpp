#include "viewport/line_pass.h"

#include <algorithm>
#include <array>

#include <glad/gl.h>
#include <glm/vec4.hpp>

#include "viewport/scene_block.h"
#include "viewport/scene_program.h"

namespace anamorph {
namespace {

constexpr int lineUnit = 4, depthUnit = 5;  // those below are the meshes' textures

bool drawable(const Line& line) {
  constexpr double farthest = 1e15;  // squares of it are still floats
  return lengthSquared(line.from) < farthest * farthest && lengthSquared(line.to) < farthest * farthest &&
         line.alpha > 0 && line.width > 0;
}

// shaders/line.vert.glsl reads this.
void append(std::vector<glm::vec4>& texels, const Line& line, const Point& origin) {
  const int kind =
      static_cast<int>(line.style) | line.arrow * LineFlags::arrow | line.inFront * LineFlags::inFront;
  texels.emplace_back(glm::vec3(line.from - origin), line.width);
  texels.emplace_back(glm::vec3(line.to - origin), kind);
  texels.emplace_back(glm::vec3(glm::clamp(line.color, 0.0, 1.0)), std::min(line.alpha, 1.0));
}

}  // namespace

LinePass::LinePass()
    : program_(makeSceneProgram("line.vert.glsl", "line.frag.glsl")), texels_(TexelFormat::rgba32f, 1) {
  program_.use();
  program_.set("lines", lineUnit);
  program_.set("depth", depthUnit);
}

void LinePass::update(const std::shared_ptr<const std::vector<Line>>& lines, const Point& origin) {
  if (lines == lines_ && origin == origin_) return;
  lines_ = lines;
  origin_ = origin;
  std::vector<glm::vec4> texels;
  for (const bool inFront : {false, true}) {  // those in front are drawn last
    for (std::size_t i = 0; lines && i < lines->size(); ++i) {
      const Line& line = (*lines)[i];
      if (line.inFront == inFront && drawable(line)) append(texels, line, origin);
    }
  }
  const std::size_t most = static_cast<std::size_t>(Texture::maxSize()) * TexelArrays::rowLength;
  if (texels.size() > most) texels.resize(most / 3 * 3);
  count_ = static_cast<int>(texels.size() / 3);
  if (count_ == 0) return;
  if (texels_.reserve(std::array{texels.size()})) texels_.make();
  texels_.write(0, 0, texels.data(), texels.size());
}

void LinePass::draw(const Texture& depth, double pixelScale, int from, int to) {
  texels_.bind(lineUnit);
  depth.bind(depthUnit);
  program_.use();
  program_.set("pixelScale", static_cast<float>(pixelScale));
  program_.set("first", from);
  glDrawArraysInstanced(GL_TRIANGLES, 0, 6, to - from);
}

}  // namespace anamorph
