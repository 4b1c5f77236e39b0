#include "app/write_queue.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace anamorph {
namespace {

constexpr double patience = 0.5;  // seconds

struct Named {
  std::string name;
  WriteQueue::Job job;
};

std::string failureOf(const WriteQueue::Job& job) {
  try {
    job();
    return {};
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "cancelled";
  }
}

}  // namespace

struct WriteQueue::State {
  std::function<void()> wake;
  mutable std::mutex mutex;
  std::condition_variable changed;
  std::deque<Named> waiting;
  std::optional<std::string> running;  // its name
  bool waking = false, ending = false;
  std::vector<Outcome> outcomes;

  bool idle() const { return waiting.empty() && !running; }
  void loop() {
    std::unique_lock<std::mutex> lock(mutex);
    while (true) {
      changed.wait(lock, [this] { return ending || !waiting.empty(); });
      if (waiting.empty()) return;
      Named next = std::move(waiting.front());
      waiting.pop_front();
      running = next.name;
      lock.unlock();
      Outcome outcome{next.name, failureOf(next.job)};
      next.job = nullptr;  // frees what it holds before anybody is told
      lock.lock();
      running.reset();
      outcomes.push_back(std::move(outcome));
      changed.notify_all();
      if (ending || !wake) continue;
      waking = true;
      lock.unlock();
      wake();
      lock.lock();
      waking = false;
      changed.notify_all();
    }
  }
};

WriteQueue::WriteQueue(std::function<void()> wake) : state_(std::make_shared<State>()) {
  state_->wake = std::move(wake);
  std::thread([state = state_] { state->loop(); }).detach();
}

WriteQueue::~WriteQueue() {
  std::unique_lock<std::mutex> lock(state_->mutex);
  state_->ending = true;
  state_->changed.notify_all();
  // Whom it wakes may be gone afterwards.
  state_->changed.wait_for(lock, std::chrono::duration<double>(patience),
                           [this] { return state_->idle() && !state_->waking; });
}

void WriteQueue::add(std::string name, Job job) {
  {
    const std::lock_guard<std::mutex> lock(state_->mutex);
    auto& waiting = state_->waiting;
    const auto same =
        std::find_if(waiting.begin(), waiting.end(), [&](const Named& other) { return other.name == name; });
    if (same != waiting.end()) {
      same->job = std::move(job);
    } else {
      waiting.push_back({std::move(name), std::move(job)});
    }
  }
  state_->changed.notify_all();
}

bool WriteQueue::idle() const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return state_->idle();
}

std::vector<WriteQueue::Outcome> WriteQueue::takeOutcomes() {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return std::exchange(state_->outcomes, {});
}

bool WriteQueue::finish(double seconds) {
  std::unique_lock<std::mutex> lock(state_->mutex);
  return state_->changed.wait_for(lock, std::chrono::duration<double>(seconds),
                                  [this] { return state_->idle(); });
}

std::vector<std::string> WriteQueue::undone(double seconds) {
  finish(seconds);
  const std::lock_guard<std::mutex> lock(state_->mutex);
  std::vector<std::string> names;
  if (state_->running) names.push_back(*state_->running);
  for (const Named& job : state_->waiting) names.push_back(job.name);
  for (const Outcome& outcome : state_->outcomes) {
    if (!outcome.failure.empty()) names.push_back(outcome.name);
  }
  return names;
}

}  // namespace anamorph
