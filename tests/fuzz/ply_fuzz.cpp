#include <cstddef>
#include <cstdint>

#include "fuzz/mesh_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  anamorph::testing::readsAsMesh({reinterpret_cast<const char*>(data), size}, "fuzz.ply");
  return 0;
}
