// A change of the level that takes too long for a frame: a mesh to read, many matches to compute. It is made
// in the background from the level as it is at the start, and comes into the session as one step, or as two. When the
// level has been changed meanwhile it comes too late: it would undo that change.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "edit/session.h"
#include "pipeline/worker.h"

namespace anamorph {

/// What a job has found: the level as it should be, or none; and what is to be said about it.
struct EditResult {
  std::optional<Level> level;
  std::string message;
  std::optional<Level> between =
      std::nullopt;  ///< a level that one step back leads to; without it, to the old one
};

class EditJob {
 public:
  /// Runs in another thread; may throw Error. Looks at the progress often, and returns soon when cancelled.
  using Make = std::function<EditResult(const Level&, const Progress&)>;

  /// `wake` is called from the other thread when there is a result.
  explicit EditJob(std::function<void()> wake = {}) : worker_(std::move(wake)) {}

  /// Begins, in place of what still runs. `name` says what is being done.
  void start(const Session& session, std::string name, Make make);
  /// Lets go of it; the level stays as it is.
  void cancel();

  /// One frame: puts a result into the session. Returns what is to be said, once.
  std::optional<std::string> update(Session& session);

  bool busy() const { return started_.has_value(); }
  /// How far it is, 0..1.
  double fraction() const { return worker_.fraction(); }
  const std::string& name() const { return name_; }

 private:
  struct Start {
    Level level;
    std::filesystem::path path;
    int generation;
  };
  std::optional<Start> started_;
  std::string name_;
  std::shared_ptr<Mailbox<EditResult>> results_;
  Worker worker_;  // last: its job uses the mailbox
};

}  // namespace anamorph
