#include "app/autosave.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "app/crash_handler.h"
#include "app/unsaved_bytes.h"
#include "base/language.h"

namespace anamorph {
namespace {

// Of jobs, which for levels that were left have the levels' absolute paths.
const std::string openName = "open", crashName = "crash", removeName = "remove";

}  // namespace

Autosave::Autosave(std::filesystem::path folder, std::function<void()> wake)
    : folder_(std::move(folder)), queue_(std::move(wake)) {}

Autosave::~Autosave() {
  if (std::uncaught_exceptions() > 0) {  // the program is failing: this is what it is for
    if (queue_.finish(0.5)) writeUnsaved();
    return;
  }
  queue_.add("end", [documents = std::move(documents_), unwanted = std::move(unwanted_)] {
    putUnsaved(nullptr);
    for (const auto& [name, document] : documents) document.file->remove();
    for (const auto& file : unwanted) file->remove();
  });
}

std::optional<std::string> Autosave::update(const Session& session, const LeftLevels& left, double now) {
  const bool idle = queue_.idle();  // before it is asked what has failed: then all of that is known
  const std::optional<std::string> news = takeNews();
  if (session.modified()) {
    // The program's own files are not written to, so it does not matter when they were.
    const auto fileTime = session.isInstalled() ? std::nullopt : session.fileTime();
    want(openName, session.path(), session.level(), fileTime, now);
    const bool rests = !session.changing() || now >= lastPrepared_ + prepareSeconds;
    if (rests && !(prepared_ == session.level())) prepare({session.path(), session.level(), fileTime}, now);
  } else {
    prepared_.reset();
  }
  for (const auto& [path, level] : left) want(path.string(), path, level, std::nullopt, now);
  for (auto document = documents_.begin(); document != documents_.end();) {
    const auto& [name, kept] = *document;
    const bool wanted = name == openName ? session.modified() : left.count(name) > 0;
    if (!wanted) unwanted_.push_back(kept.file);
    document = wanted ? std::next(document) : documents_.erase(document);
  }
  if (documents_.empty()) failure_.clear();
  if (idle) removeUnwanted(now);
  return news;
}

std::optional<std::string> Autosave::takeNews() {
  std::string failure;
  bool isWritten = false;
  for (const WriteQueue::Outcome& outcome : queue_.takeOutcomes()) {
    const auto document = documents_.find(outcome.name);
    if (document == documents_.end()) continue;
    if (outcome.failure.empty()) {
      isWritten = true;
    } else {
      failure = outcome.failure;
      document->second.kept.reset();  // tried again in a moment
    }
  }
  if (!failure.empty()) {
    if (std::exchange(failure_, failure) == failure) return std::nullopt;
    return trFormat("Unsaved changes could not be kept: {}", failure);
  }
  if (!isWritten || std::exchange(failure_, "").empty()) return std::nullopt;
  return tr("Unsaved changes are kept again.");
}

void Autosave::want(const std::string& name, const std::filesystem::path& path, const Level& level,
                    const std::optional<FileTime>& fileTime, double now) {
  Document& document = documents_[name];
  if (document.kept == level) {
    document.changed.reset();
    return;
  }
  if (!document.changed) document.changed = now;
  if (now < document.due()) return;
  document.kept = level;
  document.changed.reset();
  document.written = now;
  const UnsavedLevel unsaved{path, level, fileTime};
  if (name == openName) prepare(unsaved, now);
  queue_.add(name,
             [folder = folder_, file = document.file, unsaved] { keepUnsaved(folder, *file, unsaved); });
}

// A job of its own, whose newest is always done last: what waits to be written may be older.
void Autosave::prepare(const UnsavedLevel& unsaved, double now) {
  prepared_ = unsaved.level;
  lastPrepared_ = now;
  queue_.add(crashName, [folder = folder_, file = documents_[openName].file, unsaved] {
    prepareUnsaved(folder, *file, unsaved);
  });
}

void Autosave::removeUnwanted(double now) {
  const bool waits = std::any_of(documents_.begin(), documents_.end(), [&](const auto& document) {
    return document.second.changed || document.second.written == now;  // how that went is not known yet
  });
  if (waits || unwanted_.empty()) return;
  queue_.add(removeName, [files = std::exchange(unwanted_, {}), isSaved = documents_.count(openName) == 0] {
    if (isSaved) putUnsaved(nullptr);
    for (const auto& file : files) file->remove();
  });
}

void Autosave::adopt(RecoveryFile rescued) {
  Document& document = documents_[openName];
  unwanted_.push_back(document.file);
  document = Document();
  document.file = std::make_shared<RecoveryFile>(std::move(rescued));
  prepared_.reset();
}

std::optional<double> Autosave::secondsUntilDue(double now) const {
  std::optional<double> seconds;
  for (const auto& [name, document] : documents_) {
    if (!document.changed) continue;
    const double wait = std::max(0.0, document.due() - now);
    seconds = std::min(seconds.value_or(wait), wait);
  }
  return seconds;
}

}  // namespace anamorph
