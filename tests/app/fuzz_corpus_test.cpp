// The seeds of the fuzz targets for the program's own files, through the same checks in an ordinary test: each as it is,
// cut off anywhere, and with single bytes of others in it.
#include <filesystem>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "cli/program.h"
#include "fuzz/state_fuzz.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;

class StateCorpus : public ::testing::TestWithParam<StateReader> {
 protected:
  ~StateCorpus() override {
    std::filesystem::remove_all(std::filesystem::temp_directory_path() /
                                ("anamorph-fuzz-" + std::to_string(::getpid())));
  }
};

TEST_P(StateCorpus, IsReadOrRefused) {
  const std::filesystem::path folder =
      std::filesystem::path(ANAMORPH_TEST_DATA) / "../fuzz/corpus" / GetParam().name;
  std::size_t sound = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string bytes = readAll(entry.path());
    sound += GetParam().reads(bytes) ? 1 : 0;
    const std::size_t step = bytes.size() / 20 + 1;
    for (std::size_t at = 0; at < bytes.size(); at += step) {
      EXPECT_NO_THROW(GetParam().reads(std::string_view(bytes).substr(0, at)))
          << entry.path() << " cut at " << at;
      for (const char other : {'{', '}', '\xff', '9', '"'}) {
        std::string changed = bytes;
        changed[at] = other;
        EXPECT_NO_THROW(GetParam().reads(changed)) << entry.path() << " with " << other << " at " << at;
      }
    }
  }
  EXPECT_GT(sound, 0u) << "a seed that is right";
}

INSTANTIATE_TEST_SUITE_P(Readers, StateCorpus, ::testing::ValuesIn(stateReaders),
                         [](const auto& reader) { return std::string(reader.param.name); });

}  // namespace
}  // namespace anamorph
