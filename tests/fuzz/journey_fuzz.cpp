#include <cstddef>
#include <cstdint>

#include "fuzz/level_journey.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const anamorph::testing::TemporaryFolder folder;
  anamorph::testing::journeyOf({reinterpret_cast<const char*>(data), size}, folder / "");
  return 0;
}
