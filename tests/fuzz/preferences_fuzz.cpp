#include <cstddef>
#include <cstdint>

#include "fuzz/state_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  anamorph::testing::readsAsPreferences({reinterpret_cast<const char*>(data), size});
  return 0;
}
