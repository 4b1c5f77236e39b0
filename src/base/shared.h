// A value that is kept many times and changed seldom: copies share it, and comparing two copies of the same looks at
// nothing but a pointer.
#pragma once

#include <memory>
#include <utility>

namespace anamorph {

template <typename T>
class Shared {
 public:
  Shared() : Shared(T()) {}
  Shared(const Shared&) = default;  // copies only: what was moved from would hold nothing
  Shared& operator=(const Shared&) = default;
  Shared(T value) : value_(std::make_shared<const T>(std::move(value))) {}  // NOLINT: a T is a Shared<T>

  const T& operator*() const { return *value_; }
  const T* operator->() const { return value_.get(); }
  bool operator==(const Shared& other) const { return value_ == other.value_ || *value_ == *other.value_; }

  /// Lets `change` work on a copy, which takes the place of the value; other copies stay as they are.
  template <typename Change>
  void edit(const Change& change) {
    T copy = *value_;
    change(copy);
    value_ = std::make_shared<const T>(std::move(copy));
  }

 private:
  std::shared_ptr<const T> value_;
};

}  // namespace anamorph
