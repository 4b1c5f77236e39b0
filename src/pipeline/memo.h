// The last result of a stage, kept as long as its input stays the same value. This is all the change
// detection there is: no dirty flags, no events. Inputs compare cheaply because big data in them is shared
// and compared by pointer.
#pragma once

#include <optional>
#include <utility>

namespace anamorph {

template <typename Input, typename Output>
class Memo {
 public:
  /// The output for `input`: the kept one, or compute(input).
  template <typename Compute>
  const Output& get(const Input& input, const Compute& compute) {
    if (!input_ || !(*input_ == input)) {
      input_.reset();  // if compute throws, nothing half-made is kept
      output_.emplace(compute(input));
      input_ = input;
    }
    return *output_;
  }

  /// The kept output; nothing before the first get().
  const Output* last() const { return output_ ? &*output_ : nullptr; }

 private:
  std::optional<Input> input_;
  std::optional<Output> output_;
};

}  // namespace anamorph
