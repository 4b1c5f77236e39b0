// What the colours of the difference picture mean, in as many lines below it as they need.
#pragma once

#include <vector>

#include "math/color.h"

namespace anamorph {

struct DifferenceColor {
  Rgb color;
  const char* meaning;
};

class DifferenceLegend {
 public:
  /// `reflects`: the picture is of a mirror's reflection.
  DifferenceLegend(bool reflects, float width);

  /// With the gap below it.
  float height() const;
  void draw() const;

 private:
  std::vector<std::vector<DifferenceColor>> lines_;
};

}  // namespace anamorph
