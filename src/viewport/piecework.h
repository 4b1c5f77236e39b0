// Drawing in pieces, so that no frame waits long for a slow OpenGL: jobs one after the other, each of many small
// pieces, of which every frame draws as many as it has time for.
//
//   job     |p|p|p|p|p|p|p|p|p|p|p|p|p| then the next job
//   frames   `---1---' `--2--' `--3--'
#pragma once

#include <deque>
#include <functional>
#include <limits>

namespace anamorph {

class Piecework {
 public:
  /// Draws pieces [from, to) of a job, and sets all of OpenGL's state that it needs: frames may lie between.
  using Draw = std::function<void(int from, int to)>;

  /// All the time there is: everything in one go, and nobody waits for it.
  static constexpr double noHurry = std::numeric_limits<double>::infinity();

  /// `finish` waits until all that was asked for is drawn.
  explicit Piecework(std::function<void()> finish) : finish_(std::move(finish)) {}

  /// Behind what there is already. The pieces of a job take about as long each.
  void add(int pieces, Draw draw);
  void clear();
  bool empty() const { return jobs_.empty(); }
  /// How much is drawn of what there was to draw since it was last empty, 0..1.
  double fraction() const { return added_ > 0 ? double(drawn_) / added_ : 0; }

  /// Draws as many pieces of the first job as take about so many milliseconds, at least one. Returns how long that
  /// took (with noHurry: how long the asking took). There must be one.
  double drawSome(double milliseconds);

 private:
  struct Job {
    int pieces;
    Draw draw;
  };
  int affordable(double milliseconds) const;

  std::function<void()> finish_;
  std::deque<Job> jobs_;
  int added_ = 0, drawn_ = 0;  // pieces
  // Of the first job.
  int next_ = 0, lastCount_ = 0;
  double millisecondsPerPiece_ = 0;
};

}  // namespace anamorph
