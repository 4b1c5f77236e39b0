#include "pipeline/worker.h"

#include <chrono>
#include <exception>

namespace anamorph {

Worker::Worker(std::function<void()> wake) : wake_(std::move(wake)), thread_([this] { loop(); }) {}

Worker::~Worker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
    waiting_ = nullptr;
    if (running_) running_->cancel();
  }
  changed_.notify_all();
  thread_.join();
}

void Worker::request(Job job) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_ = std::move(job);
    failure_.reset();
    if (running_) running_->cancel();
  }
  changed_.notify_all();
}

void Worker::cancel() {
  const std::lock_guard<std::mutex> lock(mutex_);
  waiting_ = nullptr;
  failure_.reset();
  if (running_) running_->cancel();
}

bool Worker::busy() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return waiting_ || running_;
}

bool Worker::waitForEnd(double seconds) {
  std::unique_lock<std::mutex> lock(mutex_);
  return changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                           [this] { return !waiting_ && !running_; });
}

double Worker::fraction() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return fraction_;
}

std::optional<std::string> Worker::takeFailure() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(failure_, std::nullopt);
}

void Worker::loop() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || waiting_; });
    if (stopping_) return;
    Job job = std::exchange(waiting_, nullptr);
    const CancelToken token;
    running_ = token;
    fraction_ = 0;
    lock.unlock();

    std::optional<std::string> failure;
    const auto report = [this](double fraction) {
      const std::lock_guard<std::mutex> reportLock(mutex_);
      fraction_ = fraction;
    };
    try {
      job(Progress{report, token});
    } catch (const Cancelled&) {
      // Then nobody waits for it.
    } catch (const std::exception& error) {
      failure = error.what();
    }
    job = nullptr;  // frees what it holds before anybody is told

    lock.lock();
    running_.reset();
    if (failure && !token.cancelled()) failure_ = std::move(failure);
    lock.unlock();
    changed_.notify_all();
    if (wake_) wake_();
    lock.lock();
  }
}

}  // namespace anamorph
