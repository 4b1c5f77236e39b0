#include "raytrace/render.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "base/check.h"
#include "base/parallel_for.h"

namespace anamorph {
namespace {

constexpr int tileSize = 16;
constexpr int coarsestStride = 8;

TraceOptions traceOptions(const ImageRequest& request, const Projection& projection) {
  return {request.maxDepth, request.shadows, 1 / projection.pixelsPerTangent()};
}

class Renderer {
 public:
  Renderer(const RenderScene& scene, const Camera& camera, const ImageRequest& request,
           const Progress& progress)
      : scene_(scene),
        request_(request),
        progress_(progress),
        projection_(camera, request.width, request.height),
        options_(traceOptions(request, projection_)),
        samples_(samplePositions(request.samplesPerAxis)),
        image_(request.width, request.height),
        columns_((request.width + tileSize - 1) / tileSize),
        tiles_(static_cast<std::size_t>(columns_) * ((request.height + tileSize - 1) / tileSize)) {}

  /// Traces the pixels at multiples of `stride`, except those at multiples of `known`. False when cancelled.
  bool trace(int stride, int known) {
    parallelFor(tiles_, 1, request_.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t tile = begin; tile < end && !progress_.cancelled(); ++tile) {
        reportTraced(traceTile(tile, stride, known));
      }
    });
    return !progress_.cancelled();
  }

  const Image& image() const { return image_; }
  Image takeImage() { return std::move(image_); }

 private:
  // Returns the number of pixels traced.
  std::size_t traceTile(std::size_t tile, int stride, int known) {
    const int left = static_cast<int>(tile % columns_) * tileSize;
    const int top = static_cast<int>(tile / columns_) * tileSize;
    const int right = std::min(left + tileSize, request_.width);
    const int bottom = std::min(top + tileSize, request_.height);
    std::size_t traced = 0;
    for (int y = top; y < bottom; y += stride) {
      for (int x = left; x < right; x += stride) {
        if (known > 0 && x % known == 0 && y % known == 0) continue;
        if (progress_.cancelled()) return traced;
        image_.at(x, y) = glm::vec3(pixelColor(x, y));
        ++traced;
      }
    }
    return traced;
  }

  Color pixelColor(int x, int y) const {
    Color sum(0);
    for (const Pixel& sample : samples_) {
      sum += traceColor(scene_, projection_.rayThrough(Pixel(x, y) + sample), options_);
    }
    return sum / static_cast<double>(samples_.size());
  }

  void reportTraced(std::size_t pixels) {
    if (!progress_.report || pixels == 0) return;
    const std::lock_guard<std::mutex> lock(reportMutex_);
    traced_ += pixels;
    progress_.report(static_cast<double>(traced_) / static_cast<double>(image_.pixels.size()));
  }

  const RenderScene& scene_;
  const ImageRequest& request_;
  const Progress& progress_;
  const Projection projection_;
  const TraceOptions options_;
  const std::vector<Pixel> samples_;
  Image image_;
  const int columns_;
  const std::size_t tiles_;
  std::mutex reportMutex_;
  std::size_t traced_ = 0;
};

// Bilinear between the pixels at multiples of `stride`; beyond the last of them its value goes on.
Image interpolate(const Image& image, int stride) {
  const int lastX = (image.width - 1) / stride * stride, lastY = (image.height - 1) / stride * stride;
  Image result(image.width, image.height);
  for (int y = 0; y < image.height; ++y) {
    const int y0 = y / stride * stride, y1 = std::min(y0 + stride, lastY);
    const float v = static_cast<float>(y - y0) / static_cast<float>(stride);
    for (int x = 0; x < image.width; ++x) {
      const int x0 = x / stride * stride, x1 = std::min(x0 + stride, lastX);
      const float u = static_cast<float>(x - x0) / static_cast<float>(stride);
      result.at(x, y) = (1 - v) * ((1 - u) * image.at(x0, y0) + u * image.at(x1, y0)) +
                        v * ((1 - u) * image.at(x0, y1) + u * image.at(x1, y1));
    }
  }
  return result;
}

}  // namespace

std::optional<Image> render(const RenderScene& scene, const Camera& camera, const ImageRequest& request,
                            const Progress& progress) {
  Renderer renderer(scene, camera, request, progress);
  if (!renderer.trace(1, 0)) return std::nullopt;
  return renderer.takeImage();
}

std::optional<Image> renderProgressive(const RenderScene& scene, const Camera& camera,
                                       const ImageRequest& request, const OnPass& onPass,
                                       const Progress& progress) {
  Renderer renderer(scene, camera, request, progress);
  for (int stride = coarsestStride, known = 0; stride > 1; known = stride, stride /= 2) {
    if (!renderer.trace(stride, known)) return std::nullopt;
    onPass(interpolate(renderer.image(), stride), stride);
  }
  if (!renderer.trace(1, 2)) return std::nullopt;
  onPass(renderer.image(), 1);
  return renderer.takeImage();
}

RayTree tracePath(const RenderScene& scene, const Camera& camera, const ImageRequest& request,
                  const Pixel& position) {
  const Projection projection(camera, request.width, request.height);
  return tracePath(scene, projection.rayThrough(position), traceOptions(request, projection));
}

std::vector<Pixel> samplePositions(int samplesPerAxis) {
  CHECK(samplesPerAxis > 0);
  const double n = samplesPerAxis;
  std::vector<Pixel> positions;
  for (int row = 0; row < samplesPerAxis; ++row) {
    for (int column = 0; column < samplesPerAxis; ++column) {
      positions.emplace_back((column + (row + 0.5) / n) / n, (row + (n - column - 0.5) / n) / n);
    }
  }
  return positions;
}

}  // namespace anamorph
