// How a long stage tells how far it is, and learns that nobody wants its result any more.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

namespace anamorph {

/// Shared by who asks and who works; copies refer to the same request. Safe from any thread.
class CancelToken {
 public:
  void cancel() const { cancelled_->store(true, std::memory_order_relaxed); }
  bool cancelled() const { return cancelled_->load(std::memory_order_relaxed); }

 private:
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
};

/// What was asked for is not wanted any more: thrown where a stage, or something below it, cannot return that as a
/// value. Whoever has the token catches it; nobody is told.
struct Cancelled {};

struct Progress {
  /// Called with a fraction in 0..1, from one thread at a time; may be empty.
  std::function<void(double)> report;
  CancelToken token;

  /// Reports and returns whether to go on.
  bool update(double fraction) const {
    if (report) report(fraction);
    return !token.cancelled();
  }
  bool cancelled() const { return token.cancelled(); }
};

/// For a stage that takes the work from one share of the whole to another.
inline Progress partOf(const Progress& whole, double from, double to) {
  Progress part{{}, whole.token};
  if (whole.report) {
    part.report = [report = whole.report, from, to](double fraction) {
      report(from + fraction * (to - from));
    };
  }
  return part;
}

}  // namespace anamorph
