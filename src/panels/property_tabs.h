// The tabs of the properties, and the thing that each is about: choosing a tab selects its thing, selecting a thing
// in the 3D view chooses its tab.
#pragma once

#include "edit/selection.h"

namespace anamorph {

enum class PropertyTab { eye, original, mirror, sculpture, lights, rays, view };

struct PropertyTabs {
  PropertyTab open = PropertyTab::eye;
  Selection selection;  ///< that it was opened with: the tab follows when it becomes another one
};

/// Opens a tab, and selects its thing.
void openTab(PropertyTabs& tabs, Selection& selection, PropertyTab tab);

/// Opens the tab of what has been selected since the last call.
void followSelection(PropertyTabs& tabs, const Selection& selection);

}  // namespace anamorph
