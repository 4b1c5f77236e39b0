// One thread for what is written to the disk, so that no frame waits for one: jobs are done in the order in which they
// were asked for, and none is cancelled, for they are somebody's work. Where several of a name wait, the newest is done
// in their place.
//
//   frame:   add("progress", A)  add("recent", B)  add("progress", C) ......... takeOutcomes(): why which failed
//   thread:  [A runs, and fails][C][B], wakes the window after each
//
// A disk may hang for ever. Who ends waits a moment for what is left, and then leaves the thread to itself.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace anamorph {

class WriteQueue {
 public:
  /// Throws Error when it fails. What it needs it owns, for it may outlive the queue.
  using Job = std::function<void()>;
  struct Outcome {
    std::string name;
    std::string failure;  ///< empty: it is done
  };

  /// `wake` is called from the thread after every job.
  explicit WriteQueue(std::function<void()> wake = {});
  /// Waits for what is left, at most half a second.
  ~WriteQueue();
  WriteQueue(const WriteQueue&) = delete;
  WriteQueue& operator=(const WriteQueue&) = delete;

  /// Never waits.
  void add(std::string name, Job job);
  /// Whether nothing waits and nothing runs.
  bool idle() const;
  /// Of the jobs done since the last call, in their order.
  std::vector<Outcome> takeOutcomes();
  /// Waits until all is done, at most `seconds`. Returns whether it is.
  bool finish(double seconds);
  /// The same; returns the names of the jobs that are not done then, and of those that have failed since takeOutcomes()
  /// was called last.
  std::vector<std::string> undone(double seconds);

 private:
  struct State;
  std::shared_ptr<State> state_;  // the thread's, too
};

}  // namespace anamorph
