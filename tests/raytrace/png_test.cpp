#include "raytrace/png.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "base/check.h"
#include "base/error.h"

namespace anamorph {
namespace {

class PngFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("anamorph_png_") + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  static Bitmap pattern(int width, int height, int channels) {
    Bitmap bitmap{width, height, channels, {}};
    for (int i = 0; i < width * height * channels; ++i)
      bitmap.bytes.push_back(static_cast<std::uint8_t>(i * 37 % 251));
    return bitmap;
  }

  std::filesystem::path folder_;
};

TEST_F(PngFile, KeepsEveryByte) {
  for (const int channels : {3, 4}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {64, 33}}) {
      const Bitmap bitmap = pattern(width, height, channels);
      savePng(folder_ / "a.png", bitmap);
      EXPECT_EQ(loadPng(folder_ / "a.png"), bitmap) << width << " x " << height << " x " << channels;
    }
  }
}

TEST_F(PngFile, ImagesAreSavedAsTheirBitmap) {
  Image image(2, 2);
  image.at(1, 0) = {0.2f, 0.4f, 0.6f};
  savePng(folder_ / "a.png", image);
  EXPECT_EQ(loadPng(folder_ / "a.png"), toBitmap(image));
}

TEST_F(PngFile, ReplacesAndLeavesNothingElseBehind) {
  savePng(folder_ / "a.png", pattern(4, 4, 3));
  savePng(folder_ / "a.png", pattern(2, 2, 3));
  EXPECT_EQ(loadPng(folder_ / "a.png").width, 2);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(PngFile, WhatCannotBeWrittenIsAnError) {
  EXPECT_THROW(savePng(folder_ / "missing" / "a.png", pattern(1, 1, 3)), Error);
  EXPECT_THROW(savePng(folder_, pattern(1, 1, 3)), Error);
}

TEST_F(PngFile, WhatIsNoPngIsAnError) {
  const auto path = folder_ / "a.png";
  for (const std::string& text :
       {std::string(), std::string("hello"), encodePng(pattern(9, 9, 3)).substr(0, 60)}) {
    std::ofstream(path, std::ios::binary) << text;
    try {
      loadPng(path);
      FAIL() << "read " << text.size() << " bytes";
    } catch (const Error& error) {
      EXPECT_EQ(error.file, path.string());
      EXPECT_EQ(error.message.find("expected a PNG picture, got "), 0u) << error.what();
    }
  }
}

TEST_F(PngFile, BytesMustFitTheSize) {
  EXPECT_THROW(encodePng(Bitmap{2, 2, 3, std::vector<std::uint8_t>(11)}), ProgrammingError);
  EXPECT_THROW(encodePng(Bitmap{1, 1, 2, std::vector<std::uint8_t>(2)}), ProgrammingError);
  EXPECT_THROW(encodePng(Bitmap{}), ProgrammingError);
}

}  // namespace
}  // namespace anamorph
