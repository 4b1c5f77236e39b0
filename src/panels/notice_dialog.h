// Something that did not work and must not be overlooked.
#pragma once

#include <optional>
#include <string>

#include "panels/keys.h"
#include "panels/look.h"

namespace anamorph {

struct Notice {
  std::string title;  ///< English
  std::string text;
};

/// Shows it until it has been read; then there is none any more.
void drawNotice(std::optional<Notice>& notice, const DialogKeys& typed, const Look& look);

}  // namespace anamorph
