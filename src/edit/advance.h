// The step of time: between the input of a frame and its drawing everything goes on that goes on by itself.
#pragma once

#include "edit/editor.h"

namespace anamorph {

/// Goes on by `seconds`: flights, the rays' animation, what is computed. Returns whether anything changed that is
/// shown.
bool advance(Editor& editor, double seconds);

}  // namespace anamorph
