// The rows of a material, in several panels.
#pragma once

#include "optics/material.h"

namespace anamorph {

/// Returns whether anything was changed.
bool materialRows(Material& material);

}  // namespace anamorph
