// A finished level, and what the 3D view draws of it.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "gl/test_context.h"
#include "level/level_json.h"
#include "pipeline/evaluator.h"
#include "pipeline/mirror_files.h"
#include "pipeline/original.h"
#include "pipeline/picture.h"
#include "raytrace/png.h"
#include "viewport/viewport.h"

namespace anamorph::test {

/// Made once for each level, an installed one or one of the tests' data: "1-plane", "cone".
inline const LevelResult& finishedLevel(const std::string& name) {
  static std::map<std::string, LevelResult> levels;
  const auto found = levels.find(name);
  if (found != levels.end()) return found->second;
  const std::string installed = std::string(ANAMORPH_LEVELS) + "/" + name + ".json";
  const std::string path = std::filesystem::exists(installed)
                               ? installed
                               : std::string(ANAMORPH_TEST_DATA) + "/levels/" + name + ".json";
  Level level = loadLevel(path).level;
  readMirrorFiles(level, path);
  const auto shape = loadOriginal(level.original.shape, path).mesh;
  const auto original = placeOriginal(*shape, level.original.unitize, level.original.placement);
  return levels.emplace(name, *finishLevel(level, original, 0)).first->second;
}

/// The level as the view starts, small.
inline ViewportInput startInput(const LevelResult& finished, int width = 160, int height = 120) {
  ViewportInput input;
  input.width = width;
  input.height = height;
  input.level = finished.level;
  input.original = finished.original;
  input.sculpture = finished.sculpture;
  const ViewSettings& view = finished.level.view;
  input.pose = {view.eye, view.target, {0, 0, 1}, view.fovDegrees, false};
  return input;
}

/// Only what the tracer's picture shows, from the RT camera's place.
inline ViewportInput tracerInput(const LevelResult& finished, int width, int height) {
  ViewportInput input = startInput(finished, width, height);
  input.pose = lookThroughPose(finished.level.camera, finished.level.grid, width, height);
  input.display.originalLook = OriginalLook::hidden;
  input.display.rtCamera = false;
  input.display.lightMarkers = false;
  return input;
}

inline Bitmap pictureOf(Viewport& viewport, const ViewportInput& input, int samples = 1, double scale = 1) {
  EXPECT_TRUE(viewport.draw(input, scale, samples, samples));
  EXPECT_TRUE(viewport.complete());
  return viewport.readBack();
}

inline Bitmap pictureOf(const ViewportInput& input, int samples = 1) {
  Viewport viewport;
  return pictureOf(viewport, input, samples);
}

struct Rgba {
  int r = 0, g = 0, b = 0, a = 0;
  bool operator==(const Rgba&) const = default;
};

inline Rgba at(const Bitmap& bitmap, int x, int y) {
  const std::uint8_t* p = &bitmap.bytes[4 * (static_cast<std::size_t>(y) * bitmap.width + x)];
  return {p[0], p[1], p[2], p[3]};
}

inline int count(const Bitmap& bitmap, const std::function<bool(const Rgba&)>& wanted) {
  int result = 0;
  for (int y = 0; y < bitmap.height; ++y) {
    for (int x = 0; x < bitmap.width; ++x) result += wanted(at(bitmap, x, y));
  }
  return result;
}

inline bool isSculptureColor(const Rgba& c) {
  return c.r > c.g + 40 && c.r > c.b + 50;
}

}  // namespace anamorph::test
