#include "base/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "base/check.h"

namespace anamorph {

int hardwareThreads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallelFor(std::size_t count, std::size_t grain, int threads,
                 const std::function<void(std::size_t, std::size_t)>& body) {
  CHECK(grain > 0);
  const std::size_t chunks = count / grain + (count % grain != 0);
  const std::size_t wanted = static_cast<std::size_t>(threads > 0 ? threads : hardwareThreads());
  const std::size_t workers = std::min(wanted, chunks);

  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failureMutex;
  const auto work = [&] {
    try {
      for (std::size_t chunk = next++; chunk < chunks; chunk = next++) {
        const std::size_t begin = chunk * grain;
        body(begin, begin + std::min(grain, count - begin));
      }
    } catch (...) {
      next = chunks;  // the others stop after their current chunk
      const std::lock_guard<std::mutex> lock(failureMutex);
      if (!failure) failure = std::current_exception();
    }
  };

  // Threads are started per call: that costs some 15 us each, less than a frame notices, and keeps no state.
  std::vector<std::thread> helpers;
  helpers.reserve(workers);
#if !defined(__EMSCRIPTEN__) || defined(__EMSCRIPTEN_PTHREADS__)
  try {
    for (std::size_t i = 1; i < workers; ++i) helpers.emplace_back(work);
  } catch (const std::system_error&) {
    // No more threads to be had: those that run do all of the work.
  }
#endif
  work();
  for (std::thread& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace anamorph
