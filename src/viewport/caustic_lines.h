// The caustic (anamorphosis/caustic.h) as dots: lines without length.
#pragma once

#include <vector>

#include "anamorphosis/caustic.h"
#include "viewport/line.h"

namespace anamorph {

std::vector<Line> makeCausticLines(const std::vector<CausticPoint>& points);

}  // namespace anamorph
