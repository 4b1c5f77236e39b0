#include "app/export_job.h"

#include <utility>

#include "base/language.h"
#include "base/parallel_for.h"
#include "exports/export_level.h"
#include "panels/file_flow.h"

namespace anamorph {
void ExportJob::update(Editor& editor, UiState& ui) {
  ExportDialog& dialog = ui.exporting;
  const LevelResult& result = editor.updater.result();
  if (!(level_ == editor.session.level())) {
    level_ = editor.session.level();
    if (!dialog.running) dialog.say("");  // it was about another one
  }
  if (std::exchange(ui.requests.startExport, false)) {
    waiting_ = Task::write;
    writing_ = dialog.request.path;
  }
  if (std::exchange(ui.requests.checkPrint, false)) {
    waiting_ = Task::check;
    writing_.reset();
  }
  if (std::exchange(ui.requests.cancelExport, false) && (waiting_ || worker_.busy())) {
    cancelled_ = true;
    waiting_.reset();
    worker_.cancel();
    dialog.say(tr("Cancelling..."));
  }
  if (waiting_ && result.problem) {
    waiting_.reset();
    giveUpQuitting(ui, *result.problem);
    dialog.say(tr(hasSculpture(result) ? "Without a way from the eye to the sculpture nothing is exported."
                                       : "There is no sculpture to export."),
               {*result.problem});
  }
  if (waiting_ && !result.complete && !editor.updater.busy()) editor.updater.restart();  // it was cancelled
  if (waiting_ && result.complete) start(*std::exchange(waiting_, std::nullopt), result, dialog);
  const bool busy = worker_.busy();  // before its outcome is looked for: that comes first
  if (auto outcome = outcomes_->take()) {
    if (outcome->written || level_ == startedWith_) {
      dialog.say(std::move(outcome->message), std::move(outcome->lines), std::move(outcome->rows));
    } else {
      dialog.say(tr("The level has been changed meanwhile: that was said of an earlier one."));
    }
    if (outcome->written) ++editor.exported;
    cancelled_ = false;
  }
  if (auto failure = worker_.takeFailure()) {
    giveUpQuitting(ui, *failure);
    dialog.say(std::move(*failure));
    cancelled_ = false;
  }
  // What is being written when it is cancelled may still be written.
  if (cancelled_ && !busy) {
    dialog.say(tr("Cancelled. Nothing was written."));
    cancelled_ = false;
  }
  const bool runs = waiting_ || busy;
  if (!runs || cancelled_) writing_.reset();
  dialog.running = runs || ui.shot.running;
  dialog.writing = writing_.has_value();
  dialog.fraction = waiting_ ? 0 : ui.shot.running ? ui.shot.fraction : worker_.fraction();
}

std::optional<std::filesystem::path> ExportJob::unwritten(double seconds) {
  if (!writing_) return std::nullopt;
  const bool ended = !waiting_ && worker_.waitForEnd(seconds);
  const auto outcome = outcomes_->take();
  return ended && outcome && outcome->written ? std::nullopt : writing_;
}

void ExportJob::start(Task task, const LevelResult& result, const ExportDialog& dialog) {
  startedWith_ = level_;
  worker_.request(
      [task, finished = result, request = dialog.request, outcomes = outcomes_](const Progress& progress) {
        const int threads = hardwareThreads();
        Outcome outcome;
        if (task == Task::check) {
          const auto check = checkSculpture(finished, request, threads, progress);
          if (!check) return;
          const auto problems = findPrintProblems(*check, leftOutOf(finished));
          const auto hints = findPrintHints(*check);
          outcome.message = tr(!problems.empty() ? "A printer would stumble over this:"
                               : !hints.empty()  ? "It is closed and sound, but mind this:"
                                                 : "It can be printed.");
          outcome.lines = problems;
          outcome.lines.insert(outcome.lines.end(), hints.begin(), hints.end());
          outcome.rows = printCheckRows(*check);
        } else {
          const auto summary = exportLevel(finished, request, threads, progress);
          if (!summary) return;
          outcome.message = trFormat("Written: {} ({})", request.path.string(), summary->description);
          outcome.lines = summary->warnings;
          outcome.written = true;
        }
        outcomes->put(outcome);
      });
}

}  // namespace anamorph
