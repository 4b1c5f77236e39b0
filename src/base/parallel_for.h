// A loop over [0, count) on several threads. Chunks are handed out as threads become free, so only loops whose
// iterations do not depend on each other give the same result for every thread count.
#pragma once

#include <cstddef>
#include <functional>

namespace anamorph {

/// The number of hardware threads, at least 1.
int hardwareThreads();

/// Calls body(begin, end) for chunks of at most `grain` >= 1 indices that together cover [0, count) once.
/// `threads` <= 0 means all hardware threads; the calling thread is one of them. The first exception that a
/// body throws is rethrown here, after all threads have stopped.
void parallelFor(std::size_t count, std::size_t grain, int threads,
                 const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace anamorph
