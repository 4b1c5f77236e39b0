// Pictures of a scene: the tracer run over all pixels, in tiles, on several threads. The result does not
// depend on the number of threads, nor on whether coarse passes were shown on the way: every pixel is
// computed alone, from fixed sample positions.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "optics/camera.h"
#include "raytrace/image.h"
#include "raytrace/scene.h"
#include "raytrace/tracer.h"

namespace anamorph {

struct ImageRequest {
  bool operator==(const ImageRequest&) const = default;

  int width = 512;
  int height = 512;
  int samplesPerAxis = 1;  ///< its square is the number of samples a pixel
  int maxDepth = 3;        ///< reflections in a row, 0..maxTraceDepth
  bool shadows = true;
  int threads = 0;  ///< as for parallelFor
};

/// The image seen by the camera; nothing when it was cancelled. A pixel is the mean of its samples.
std::optional<Image> render(const RenderScene& scene, const Camera& camera, const ImageRequest& request,
                            const Progress& progress = {});

/// Called with a complete image and the distance between its traced pixels: 8, 4, 2, then 1 for the final
/// image.
using OnPass = std::function<void(const Image&, int stride)>;

/// As render(), but coarse images are shown on the way: every 8th, 4th, 2nd pixel of every 8th, ... row is
/// traced and the others are interpolated. No pixel is traced twice. `onPass` is called from the calling
/// thread.
std::optional<Image> renderProgressive(const RenderScene& scene, const Camera& camera,
                                       const ImageRequest& request, const OnPass& onPass,
                                       const Progress& progress = {});

/// The rays behind one image position, traced as render() does. With samplesPerAxis 1, the colour at a
/// pixel's centre is the colour of that pixel.
RayTree tracePath(const RenderScene& scene, const Camera& camera, const ImageRequest& request,
                  const Pixel& position);

/// Where the samples of a pixel lie in it, 0..1: a rotated grid, so that nearly horizontal and vertical edges
/// get as many steps as there are samples. One sample lies in the middle.
std::vector<Pixel> samplePositions(int samplesPerAxis);

}  // namespace anamorph
