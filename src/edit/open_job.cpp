#include "edit/open_job.h"

#include <utility>

#include "base/error.h"
#include "geometry/mesh_files.h"

namespace anamorph {

void OpenJob::start(std::filesystem::path path) {
  path_ = std::move(path);
  outcomes_ =
      std::make_shared<Mailbox<Outcome>>();  // one that is cancelled may still deliver, to the old one
  worker_.request([path = *path_, outcomes = outcomes_](const Progress& progress) {
    Outcome outcome;
    try {
      outcome.file = readLevelFile(path, &progress.token);
    } catch (const Error&) {
      outcome.failure = std::current_exception();
      // What it is says more than where it stops being JSON.
      if (const std::string other = foreignFormatOf(path); !other.empty())
        outcome.failure = std::make_exception_ptr(Error("expected a level; " + other, path.string()));
    }
    outcomes->put(std::move(outcome));
  });
}

void OpenJob::cancel() {
  worker_.cancel();
  path_.reset();
}

std::optional<LevelFile> OpenJob::take(double patienceSeconds) {
  if (!path_) return std::nullopt;
  worker_.waitForEnd(patienceSeconds);
  const bool ended = !worker_.busy();  // before the outcome is looked for: that comes first
  auto outcome = outcomes_->take();
  if (!outcome && !ended) return std::nullopt;
  path_.reset();
  if (!outcome) throw Error(worker_.takeFailure().value_or("it was not read"));
  if (outcome->failure) std::rethrow_exception(outcome->failure);
  return std::move(outcome->file);
}

}  // namespace anamorph
