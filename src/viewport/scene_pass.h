// The lit scene. First the meshes are drawn (or traced), which tells the triangle that each pixel sees; then
// passes over all pixels meet mirror, ground and sky, and shade (shaders/scene_pass.frag.glsl). So nothing is
// shaded that is not seen, and direct view and reflection go through the same shading. All of it as pieces of work
// (piecework.h), which refer to what they were made with.
#pragma once

#include <compare>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/shader.h"
#include "raytrace/image.h"
#include "viewport/bands.h"
#include "viewport/piecework.h"
#include "viewport/scene_block.h"

namespace anamorph {

/// A picture that is the mean of samples. Each is drawn into sample(), then added to the mean.
class SampleMean {
 public:
  /// The formats of a sample's framebuffer; the mean is of the first.
  SampleMean(std::initializer_list<TexelFormat> formats, bool withDepth);

  void resize(const PixelSize& size) { size_ = size; }
  const PixelSize& size() const { return size_; }
  /// Of that size once the work of addBegin() is done.
  const Framebuffer& sample() const { return sample_; }
  /// The work before sample number `number` is drawn, and after it.
  void addBegin(Piecework& work, int number);
  void addEnd(Piecework& work, int number);

  const Texture& result() const { return single_ ? sample_.color() : mean_.color(); }

 private:
  void copySample(const Bands& bands, int from, int to) const;

  const std::vector<TexelFormat> formats_;
  const bool withDepth_;
  ShaderProgram copy_;
  PixelSize size_;
  Framebuffer sample_, mean_;
  bool single_ = true;  // a mean of one is that one: the mean is not made before a second sample comes
};

class ScenePass {
 public:
  ScenePass();

  void resize(const PixelSize& size) { mean_.resize(size); }
  /// The image on the RT camera's pixel grid; null: none.
  void setScreen(const std::shared_ptr<const Image>& screen);

  /// The work of adding a sample to the mean; number 0 begins a new one. While it is done the textures of the meshes
  /// are bound and the scene block is written.
  void add(Piecework& work, const SurfaceSlots& slots, const Visible& visible, int number);

  /// The mean: linear light times alpha, alpha.
  const Texture& light() const { return mean_.result(); }
  /// The last sample: its light, and for lines lineDepth() of shaders/camera.glsl.
  const Framebuffer& sample() const { return mean_.sample(); }

 private:
  /// What a program is made for, see scene_pass.frag.glsl.
  struct PixelProgram {
    ShaderKinds kinds;
    bool traced = false;
    auto operator<=>(const PixelProgram&) const = default;
  };

  void addTriangles(Piecework& work, Framebuffer& target, const SurfaceSlots& slots, const Visible& visible,
                    bool ghost);
  void addDrawnTriangles(Piecework& work, const Framebuffer& target, const SurfaceSlots& slots, int surfaces);
  void addPixels(Piecework& work, const Visible& visible);
  void make(const PixelProgram& kind);

  ShaderProgram triangles_, traced_;
  std::map<PixelProgram, ShaderProgram> programs_;  // made when needed
  Framebuffer seen_, seenGhost_;
  SampleMean mean_{{TexelFormat::rgba16f, TexelFormat::r32f}, true};
  Texture screen_;
  std::shared_ptr<const Image> shown_;
};

}  // namespace anamorph
