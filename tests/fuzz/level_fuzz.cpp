// Any bytes: parseLevel refuses them with an Error or gives a level, and a level that was read can be written
// and read again without loss.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/check.h"
#include "base/error.h"
#include "level/level_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace anamorph;
  LoadedLevel loaded;
  try {
    loaded = parseLevel({reinterpret_cast<const char*>(data), size}, "fuzz.json");
  } catch (const Error&) {
    return 0;
  }
  if (loaded.isThesisScene) loaded.level.original.shape = FileShape{"model.obj"};
  CHECK(parseLevel(formatLevel(loaded.level), "again.json").level == loaded.level);
  return 0;
}
