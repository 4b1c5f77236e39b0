// The controls that a step of a lesson can point at ("widget").
#pragma once

#include <string>
#include <vector>

namespace anamorph {

/// The English names of the rows and buttons of the property tabs, the preview, the lesson and the 3D view.
const std::vector<std::string>& stepControls();

}  // namespace anamorph
