#include "app/unsaved_bytes.h"

#include <atomic>

namespace anamorph {
namespace {

// A signal handler has no other way to anything. Who exchanges a pointer out of it owns what it points to.
std::atomic<const UnsavedBytes*> newest{nullptr};
static_assert(std::atomic<const UnsavedBytes*>::is_always_lock_free);

}  // namespace

void putUnsaved(std::unique_ptr<const UnsavedBytes> unsaved) {
  delete newest.exchange(unsaved.release());
}

const UnsavedBytes* takeUnsaved() noexcept {
  return newest.exchange(nullptr);
}

}  // namespace anamorph
