#include "app/quit.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "base/temporary_file.h"
#include "cli/print.h"

namespace anamorph {

void reportUnwritten(const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& file : files) {
    printLine(stderr, file.string() + ": was not written: the window was closed before");
  }
}

// Destructors would wait for the threads that hang, so none runs.
void endProgramIn(double seconds) {
  std::thread([seconds] {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    removeTemporaries();
    std::_Exit(EXIT_SUCCESS);
  }).detach();
}

}  // namespace anamorph
