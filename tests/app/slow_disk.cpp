// Loaded into the program before the C library (LD_PRELOAD): reading and writing in a folder named slow-disk takes
// as long as ANAMORPH_SLOW_SECONDS says, as on a network that does not answer.

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <string>

namespace {

void sleepIfSlow(int file) {
  const char* const seconds = std::getenv("ANAMORPH_SLOW_SECONDS");
  if (!seconds || file < 3) return;
  char path[4096];
  const std::string link = "/proc/self/fd/" + std::to_string(file);
  const ssize_t length = ::readlink(link.c_str(), path, sizeof(path) - 1);
  if (length <= 0) return;
  path[length] = 0;
  if (std::strstr(path, "/slow-disk/")) ::sleep(static_cast<unsigned>(std::atoi(seconds)));
}

template <typename Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" ssize_t read(int file, void* bytes, size_t size) {
  static auto* const real = next<ssize_t(int, void*, size_t)>("read");
  sleepIfSlow(file);
  return real(file, bytes, size);
}

extern "C" ssize_t write(int file, const void* bytes, size_t size) {
  static auto* const real = next<ssize_t(int, const void*, size_t)>("write");
  sleepIfSlow(file);
  return real(file, bytes, size);
}
