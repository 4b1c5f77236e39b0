// The construction of one vertex (edit/construction.h) as lines, in the same colours and styles as the rays.
#pragma once

#include <vector>

#include "edit/construction.h"
#include "viewport/line.h"

namespace anamorph {

std::vector<Line> makeConstructionLines(const Construction& construction);

}  // namespace anamorph
