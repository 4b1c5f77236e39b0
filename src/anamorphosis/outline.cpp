#include "anamorphosis/outline.h"

#include <algorithm>
#include <array>

#include "base/parallel_for.h"

namespace anamorph {
namespace {

constexpr int fine = 4;  // places along a side of a pixel

// Which of the two is there: what outlines are of.
struct Shown {
  bool original = false, reflection = false;
  bool operator==(const Shown&) const = default;
};

Shown shownBy(PixelClass kind) {
  const bool unseen = kind == PixelClass::hidden || kind == PixelClass::missed;
  return {showsOriginal(kind), showsReflection(kind) || unseen};
}

using FinePixel = std::array<Shown, fine * fine>;  // row by row

// The picture in fine places, of which those of a pixel inside are all the same.
class FinePicture {
 public:
  FinePicture(const std::vector<PixelClass>& classes, int width, int height)
      : classes_(classes), width_(width), height_(height), fineOf_(classes.size(), -1) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (!isAtEnd(x, y)) continue;
        fineOf_[indexOf(x, y)] = static_cast<int>(ends_.size());
        ends_.push_back({x, y});
      }
    }
    pixels_.resize(ends_.size());
  }

  void sample(const std::function<PixelClass(const Pixel&)>& classAt, int threads, const Progress& progress) {
    parallelFor(ends_.size(), 64, threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last && !progress.cancelled(); ++i) {
        for (int k = 0; k < fine * fine; ++k) {
          const Pixel place{ends_[i][0] + (k % fine + 0.5) / fine, ends_[i][1] + (k / fine + 0.5) / fine};
          pixels_[i][k] = shownBy(classAt(place));
        }
      }
    });
  }

  Outlines outlines() const {
    Outlines found;
    for (const auto& [x, y] : ends_) {
      for (int k = 0; k < fine * fine; ++k) addBorders(found, fine * x + k % fine, fine * y + k / fine);
    }
    return found;
  }

 private:
  std::size_t indexOf(int x, int y) const { return static_cast<std::size_t>(y) * width_ + x; }
  Shown coarse(int x, int y) const { return shownBy(classes_[indexOf(x, y)]); }

  bool isAtEnd(int x, int y) const {
    const Shown own = coarse(x, y);
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height_ - 1); ++j) {
      for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width_ - 1); ++i) {
        if (!(coarse(i, j) == own)) return true;
      }
    }
    return false;
  }

  // In fine coordinates.
  bool isFine(int x, int y) const { return fineOf_[indexOf(x / fine, y / fine)] >= 0; }
  Shown at(int x, int y) const {
    const int pixel = fineOf_[indexOf(x / fine, y / fine)];
    return pixel < 0 ? coarse(x / fine, y / fine) : pixels_[pixel][x % fine + fine * (y % fine)];
  }

  void addBorders(Outlines& found, int x, int y) const {
    constexpr int steps[][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const Shown own = at(x, y);
    for (const auto& [dx, dy] : steps) {
      const int i = x + dx, j = y + dy;
      if (i < 0 || j < 0 || i >= fine * width_ || j >= fine * height_) continue;
      if (dx + dy < 0 && isFine(i, j)) continue;  // asked from there
      const Shown other = at(i, j);
      const Pixel between((x + i + 1) / (2.0 * fine), (y + j + 1) / (2.0 * fine));
      if (own.original != other.original) found.original.push_back(between);
      if (own.reflection != other.reflection) found.reflection.push_back(between);
    }
  }

  const std::vector<PixelClass>& classes_;
  int width_, height_;
  std::vector<int> fineOf_;               // of each pixel its place in pixels_, -1: inside
  std::vector<std::array<int, 2>> ends_;  // the pixels at an end
  std::vector<FinePixel> pixels_;
};

}  // namespace

Outlines findOutlines(const std::vector<PixelClass>& classes, int width, int height,
                      const std::function<PixelClass(const Pixel&)>& classAt, int threads,
                      const Progress& progress) {
  FinePicture picture(classes, width, height);
  picture.sample(classAt, threads, progress);
  if (progress.cancelled()) return {};
  return picture.outlines();
}

}  // namespace anamorph
