// A value that is made when it is first asked for, once, by whichever thread comes first. A copy makes its own.
#pragma once

#include <mutex>
#include <optional>

namespace anamorph {

template <typename T>
class Lazy {
 public:
  Lazy() = default;
  Lazy(const Lazy&) {}
  Lazy& operator=(const Lazy&) = delete;

  /// `make()` has to give the same at every call.
  template <typename Make>
  const T& get(const Make& make) const {
    std::call_once(once_, [&] { value_.emplace(make()); });
    return *value_;
  }

 private:
  mutable std::once_flag once_;
  mutable std::optional<T> value_;
};

}  // namespace anamorph
