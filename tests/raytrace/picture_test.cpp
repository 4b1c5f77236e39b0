// Pictures as they were when somebody last looked at them and liked them. After a wanted change run the tests
// with ANAMORPH_UPDATE_PICTURES=1, look at tests/data/images, and commit what is right.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "raytrace/png.h"
#include "raytrace/test_scenes.h"
#include "shapes.h"

namespace anamorph::test {
namespace {

SceneInput sphereScene() {
  SceneInput input = makeStudio();
  input.optic = makeMirror(SphereMirror{{0, 0, 2}, 2});
  input.surfaces.push_back(
      makeSurface("plate", makeFloor(1, 5.5), Material{{0.1, 0.4, 0.8}, 0.3, 0.7, 0.2, 30}));
  return input;
}

// Small differences are allowed: another machine's pow() may round otherwise, and edges may move by a sample.
void expectPicture(const std::string& name, const SceneInput& input) {
  ImageRequest request = smallImage(96, 80, 2);
  request.samplesPerAxis = 3;
  const Bitmap picture = toBitmap(*render(buildScene(input), studioCamera(), request));
  const auto path = std::filesystem::path(ANAMORPH_TEST_DATA) / "images" / (name + ".png");
  if (std::getenv("ANAMORPH_UPDATE_PICTURES")) savePng(path, picture);

  const Bitmap expected = loadPng(path);
  const BitmapDifference difference = compare(picture, expected, 6);
  if (difference.meanAbsolute < 0.25 && difference.fractionOver < 0.002) return;
  Bitmap shown = picture;
  for (std::size_t i = 0; i < shown.bytes.size(); ++i) {
    shown.bytes[i] = static_cast<std::uint8_t>(std::abs(int{picture.bytes[i]} - int{expected.bytes[i]}));
  }
  const std::filesystem::path folder = testing::TempDir();
  savePng(folder / (name + "-out.png"), picture);
  savePng(folder / (name + "-diff.png"), shown);
  ADD_FAILURE() << path << " differs by " << difference.meanAbsolute << " on average, "
                << 100 * difference.fractionOver << " % of pixels by more than 6; see "
                << folder / (name + "-out.png") << " and " << folder / (name + "-diff.png");
}

TEST(Picture, CylinderInTheStudio) {
  expectPicture("studio-cylinder", makeStudio());
}

TEST(Picture, SphereInTheStudio) {
  expectPicture("studio-sphere", sphereScene());
}

}  // namespace
}  // namespace anamorph::test
