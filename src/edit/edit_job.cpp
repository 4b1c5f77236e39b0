#include "edit/edit_job.h"

#include <utility>

#include "base/language.h"

namespace anamorph {

void EditJob::start(const Session& session, std::string name, Make make) {
  started_ = Start{session.level(), session.path(), session.generation()};
  name_ = std::move(name);
  results_ =
      std::make_shared<Mailbox<EditResult>>();  // one that is cancelled may still deliver, to the old one
  worker_.request([level = session.level(), make = std::move(make), results = results_](const Progress& p) {
    EditResult result = make(level, p);
    if (!p.cancelled()) results->put(std::move(result));
  });
}

void EditJob::cancel() {
  worker_.cancel();
  started_.reset();
}

std::optional<std::string> EditJob::update(Session& session) {
  if (!started_) return std::nullopt;
  if (session.generation() != started_->generation) {
    cancel();
    return std::nullopt;
  }
  if (auto failure = worker_.takeFailure()) {
    started_.reset();
    return failure;
  }
  auto result = results_->take();
  if (!result) return std::nullopt;
  // Names of files in a level are relative to its own.
  const bool same = session.level() == started_->level && session.path() == started_->path;
  started_.reset();
  if (!same) return name_ + ": " + tr("the level has been changed meanwhile, so nothing was done.");
  if (!result->level) return result->message;
  if (result->between) session.edit(std::move(*result->between));
  session.edit(std::move(*result->level));
  return result->message;
}

}  // namespace anamorph
