#include "edit/display_settings.h"

namespace anamorph {

DisplaySettings shown(DisplaySettings settings) {
  const ShownAlone alone = settings.alone;
  if (alone == ShownAlone::nothing) return settings;
  settings.originalLook = alone == ShownAlone::original ? OriginalLook::solid : OriginalLook::hidden;
  settings.sculpture = alone == ShownAlone::sculpture;
  settings.mirror = alone == ShownAlone::mirror;
  settings.rtCamera = settings.lightMarkers = false;
  return settings;
}

}  // namespace anamorph
