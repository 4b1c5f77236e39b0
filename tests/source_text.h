// The project's own files, for tests that look at them.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

namespace anamorph {

inline const std::filesystem::path sourceFolder = ANAMORPH_SOURCE_DIR;

/// The whole file; a file that cannot be read fails the test.
inline std::string textOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace anamorph
