// How large and how smooth the 3D view is drawn: full size and many samples where there is time, less where
// drawing is slow and something moves. The window stays responsive: a frame draws for so long and no longer, and the
// fine picture comes when all is still.
#pragma once

#include <limits>

namespace anamorph {

struct ViewQuality {
  double scale = 1;                                               ///< of the picture's size
  int samplesNow = 1;                                             ///< in this frame
  int samples = 1;                                                ///< in all
  double milliseconds = std::numeric_limits<double>::infinity();  ///< that the frame draws

  bool operator==(const ViewQuality&) const = default;
};

class QualityGovernor {
 public:
  explicit QualityGovernor(bool software) : software_(software) {}

  /// For the next frame. `moving`: the picture differs from the last one.
  ViewQuality next(bool moving, double secondsStill);
  /// How long samples took, at the scale and number they were drawn with.
  void took(const ViewQuality& quality, double milliseconds);
  /// What is drawn from now on may take much longer than what was.
  void forget() { millisecondsPerSample_ = 0; }

  /// Whether there is nothing finer than this.
  bool isFinal(const ViewQuality& quality) const;

  /// For pictures that are saved: everything.
  static ViewQuality best() { return {1, 4, 16}; }

 private:
  bool slow() const;

  bool software_;
  double millisecondsPerSample_ = 0;  // at scale 1; 0: not known
};

}  // namespace anamorph
