#include "raytrace/render.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <utility>

#include "base/check.h"
#include "raytrace/test_scenes.h"

namespace anamorph::test {
namespace {

TEST(SamplePositions, LieEvenlyAroundTheMiddle) {
  EXPECT_EQ(samplePositions(1), std::vector<Pixel>{Pixel(0.5, 0.5)});
  for (int n = 2; n <= 4; ++n) {
    Pixel sum(0);
    std::vector<int> rows(n * n), columns(n * n);
    for (const Pixel& sample : samplePositions(n)) {
      sum += sample;
      ++columns[static_cast<int>(sample.x * n * n)];
      ++rows[static_cast<int>(sample.y * n * n)];
    }
    EXPECT_LT(glm::length(sum / double(n * n) - Pixel(0.5)), 1e-15);
    EXPECT_EQ(rows, std::vector<int>(n * n, 1)) << "one sample in every row of n * n";
    EXPECT_EQ(columns, std::vector<int>(n * n, 1));
  }
  EXPECT_THROW(samplePositions(0), ProgrammingError);
}

TEST(Render, DoesNotDependOnTheNumberOfThreads) {
  const RenderScene scene = buildScene(makeStudio());
  ImageRequest request = smallImage(71, 53);  // no multiple of a tile
  request.samplesPerAxis = 2;
  const auto one = render(scene, studioCamera(), request);
  ASSERT_TRUE(one);
  for (const int threads : {2, 4, 0}) {
    request.threads = threads;
    EXPECT_EQ(render(scene, studioCamera(), request), one) << threads << " threads";
  }
}

TEST(Render, APixelIsTheMeanOfItsSamples) {
  const RenderScene scene = buildScene(makeStudio());
  ImageRequest request = smallImage(20, 20);
  request.samplesPerAxis = 3;
  const auto image = render(scene, studioCamera(), request);
  ASSERT_TRUE(image);
  for (const Pixel pixel : {Pixel(3, 4), Pixel(10, 12), Pixel(19, 19)}) {
    Color sum(0);
    for (const Pixel& sample : samplePositions(3)) {
      sum += tracePath(scene, studioCamera(), request, pixel + sample).color;
    }
    EXPECT_EQ(image->at(static_cast<int>(pixel.x), static_cast<int>(pixel.y)), glm::vec3(sum / 9.0));
  }
}

TEST(Render, LooksTheSameAtEveryScale) {
  const auto picture = [](double scale) {
    Camera camera = studioCamera();
    camera.eye *= scale;
    camera.target *= scale;
    return toBitmap(*render(buildScene(scaled(makeStudio(), scale)), camera, smallImage(96, 96)));
  };
  const Bitmap usual = picture(1);
  for (const double scale : {1e-3, 0.1, 300.0, 1e5}) {
    EXPECT_LT(compare(picture(scale), usual, 2).fractionOver, 0.003) << "scale " << scale;
  }
}

TEST(Render, ReportsEveryPixelOnce) {
  for (const bool progressive : {false, true}) {
    double last = 0;
    Progress progress;
    progress.report = [&](double fraction) {
      EXPECT_GT(fraction, last);
      last = fraction;
    };
    const RenderScene scene = buildScene(makeStudio());
    const ImageRequest request = smallImage(50, 37, 2);
    if (progressive) {
      renderProgressive(
          scene, studioCamera(), request, [](const Image&, int) {}, progress);
    } else {
      render(scene, studioCamera(), request, progress);
    }
    EXPECT_EQ(last, 1);
  }
}

TEST(RenderProgressive, EndsWithTheImageOfRender) {
  const RenderScene scene = buildScene(makeStudio());
  for (const auto& [width, height] : {std::pair{61, 47}, {8, 8}, {1, 1}, {3, 90}}) {
    ImageRequest request = smallImage(width, height, 2);
    request.samplesPerAxis = 2;
    std::vector<int> strides;
    Image shown;
    const auto image = renderProgressive(scene, studioCamera(), request, [&](const Image& pass, int stride) {
      strides.push_back(stride);
      shown = pass;
    });
    EXPECT_EQ(image, render(scene, studioCamera(), request)) << width << " x " << height;
    EXPECT_EQ(shown, image);
    EXPECT_EQ(strides, (std::vector<int>{8, 4, 2, 1}));
  }
}

TEST(RenderProgressive, CoarsePassesAreCompleteAndGetBetter) {
  const RenderScene scene = buildScene(makeStudio());
  const ImageRequest request = smallImage(96, 96);
  std::vector<Image> passes;
  renderProgressive(scene, studioCamera(), request, [&](const Image& pass, int) { passes.push_back(pass); });
  ASSERT_EQ(passes.size(), 4u);
  double last = 256;
  for (const Image& pass : passes) {
    for (int y = 0; y < 96; y += 8) {
      for (int x = 0; x < 96; x += 8)
        EXPECT_EQ(pass.at(x, y), passes.back().at(x, y)) << "traced, not interpolated";
    }
    const double error = compare(toBitmap(pass), toBitmap(passes.back()), 0).meanAbsolute;
    EXPECT_LT(error, last);
    last = error;
  }
  EXPECT_LT(compare(toBitmap(passes[0]), toBitmap(passes[3]), 0).meanAbsolute, 12) << "no black holes";
}

TEST(RenderProgressive, CoarsePassesInterpolateBothWays) {
  for (const Direction& up : {Direction(0, 0, 1), Direction(1, 0, 0), Direction(1, 0, 1)}) {
    Camera camera;  // nothing but the background's gradient, turned
    camera.up = up;
    std::vector<Image> passes;
    renderProgressive(buildScene({}), camera, smallImage(65, 65),
                      [&](const Image& p, int) { passes.push_back(p); });
    ASSERT_EQ(passes.size(), 4u);
    for (const Image& pass : passes) {
      for (std::size_t i = 0; i < pass.pixels.size(); ++i) {
        ASSERT_LT(glm::length(pass.pixels[i] - passes[3].pixels[i]), 1e-3f) << "pixel " << i;
      }
    }
  }
}

TEST(Render, CancelledBeforeItBeginsGivesNothing) {
  const RenderScene scene = buildScene(makeStudio());
  Progress progress;
  progress.report = [](double) { FAIL() << "traced something"; };
  progress.token.cancel();
  EXPECT_FALSE(render(scene, studioCamera(), smallImage(64, 64), progress));
  EXPECT_FALSE(renderProgressive(
      scene, studioCamera(), smallImage(64, 64), [](const Image&, int) { FAIL(); }, progress));
}

TEST(Render, CancelStopsAfterTheTilesAtWork) {
  const RenderScene scene = buildScene(makeStudio());
  Progress progress;
  int reports = 0;
  progress.report = [&](double) {
    ++reports;
    progress.token.cancel();
  };
  EXPECT_FALSE(render(scene, studioCamera(), smallImage(256, 256), progress));
  EXPECT_EQ(reports, 1);
}

TEST(Render, CancelFromAnotherThreadIsQuick) {
  const RenderScene scene = buildScene(makeStudio());
  ImageRequest request = smallImage(16, 16, 2);  // one tile, half a second of work
  request.samplesPerAxis = 50;
  const Progress progress;
  std::chrono::steady_clock::time_point cancelled;
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    cancelled = std::chrono::steady_clock::now();
    progress.token.cancel();
  });
  EXPECT_FALSE(render(scene, studioCamera(), request, progress));
  const auto returned = std::chrono::steady_clock::now();
  other.join();
  // At most one pixel, here some 2 ms; the limit leaves room for a busy machine and sanitizers.
  EXPECT_LT(returned - cancelled, std::chrono::milliseconds(250));
}

TEST(RenderProgressive, ShowsNothingAfterACancel) {
  const RenderScene scene = buildScene(makeStudio());
  const Progress progress;
  int passes = 0;
  EXPECT_FALSE(renderProgressive(
      scene, studioCamera(), smallImage(64, 64),
      [&](const Image&, int stride) {
        ++passes;
        if (stride == 4) progress.token.cancel();
      },
      progress));
  EXPECT_EQ(passes, 2);
}

}  // namespace
}  // namespace anamorph::test
