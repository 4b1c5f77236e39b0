// The drawings of lessons and help, made of lines and letters: sharp at every scale, in the colours of the
// theme and of the rays.
#pragma once

#include <string>

#include "panels/look.h"

namespace anamorph {

/// Draws a figure (stepFigures in level/lesson.h) as wide as the column; nothing for an unknown name.
void drawFigure(const std::string& name, const Look& look);

}  // namespace anamorph
