#include "viewport/piecework.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/check.h"

namespace anamorph {

void Piecework::add(int pieces, Draw draw) {
  if (pieces <= 0) return;
  if (empty()) added_ = drawn_ = 0;
  added_ += pieces;
  jobs_.push_back({pieces, std::move(draw)});
}

void Piecework::clear() {
  jobs_.clear();
  next_ = 0;
}

// One piece first, then at most twice as many as the last time: they only take about as long each.
int Piecework::affordable(double milliseconds) const {
  if (next_ == 0) return 1;
  const double count = milliseconds / std::max(millisecondsPerPiece_, 1e-6);
  return static_cast<int>(std::clamp(count, 1.0, 2.0 * lastCount_));
}

double Piecework::drawSome(double milliseconds) {
  CHECK(!empty());
  using Clock = std::chrono::steady_clock;
  const bool hurry = milliseconds < noHurry;
  Job& job = jobs_.front();
  const int left = job.pieces - next_, count = hurry ? std::min(affordable(milliseconds), left) : left;
  const auto start = Clock::now();
  job.draw(next_, next_ + count);
  if (hurry) finish_();
  const double took = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  next_ += count;
  drawn_ += count;
  lastCount_ = count;
  // The last pieces were cheaper than the next ones may be: what was learnt is forgotten slowly.
  millisecondsPerPiece_ = std::max(took / count, next_ > count ? 0.7 * millisecondsPerPiece_ : 0.0);
  if (next_ == job.pieces) {
    jobs_.pop_front();
    next_ = 0;
  }
  return took;
}

}  // namespace anamorph
