#include "edit/save_job.h"

#include <utility>

#include "base/error.h"

namespace anamorph {
namespace {

SaveOutcome write(const std::filesystem::path& path, const Level& level, std::optional<FileTime> known) {
  SaveOutcome outcome;
  outcome.path = path;
  outcome.changedElsewhere = isWrittenElsewhere(path, known);
  if (outcome.changedElsewhere) return outcome;
  try {
    outcome.lost = saveLevel(path, level);
    outcome.time = timeOf(path);
  } catch (const Error& error) {
    outcome.failure = error.what();
  }
  return outcome;
}

}  // namespace

void SaveJob::start(Session& session, const std::filesystem::path& path, std::optional<FileTime> known) {
  saving_ = session.prepareSave(path);
  worker_.request([saving = *saving_, known, outcomes = outcomes_](const Progress&) {
    outcomes->put(write(saving.path, saving.level, known));
  });
}

std::optional<SaveOutcome> SaveJob::take(Session& session, double patienceSeconds) {
  if (!saving_) return std::nullopt;
  worker_.waitForEnd(patienceSeconds);
  const bool ended = !worker_.busy();  // before the outcome is looked for: that comes first
  auto outcome = outcomes_->take();
  if (!outcome && !ended) return std::nullopt;
  const SavedLevel saved = *std::exchange(saving_, std::nullopt);
  if (!outcome) {
    outcome.emplace();
    outcome->path = saved.path;
    outcome->failure = worker_.takeFailure().value_or("it was not written");
  }
  outcome->isOfAnEarlierLevel = saved.generation != session.generation();
  if (outcome->failure.empty() && !outcome->changedElsewhere) session.finishSave(saved, outcome->time);
  return outcome;
}

std::optional<std::filesystem::path> SaveJob::unwritten(double seconds) {
  if (!saving_) return std::nullopt;
  const bool ended = worker_.waitForEnd(seconds);
  const auto outcome = outcomes_->take();
  const bool written = ended && outcome && outcome->failure.empty() && !outcome->changedElsewhere;
  return written ? std::nullopt : std::optional(saving_->path);
}

}  // namespace anamorph
