// Big results that are made anew every frame: shared and immutable for whoever holds them, and still without
// taking memory every time. A buffer that nobody holds any more is written again.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

namespace anamorph {

template <typename T>
class BufferRing {
 public:
  /// A buffer that nobody else holds: one of those handed out before, else what make() gives.
  template <typename Make>
  std::shared_ptr<T> take(const Make& make) {
    for (const std::shared_ptr<T>& buffer : buffers_) {
      if (buffer.use_count() != 1) continue;
      // What another thread read before it let go comes before what is written now.
      std::atomic_thread_fence(std::memory_order_acquire);
      return buffer;
    }
    buffers_.push_back(std::make_shared<T>(make()));
    return buffers_.back();
  }

 private:
  std::vector<std::shared_ptr<T>> buffers_;
};

}  // namespace anamorph
