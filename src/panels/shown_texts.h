// The texts of strangers that the window may show: of levels, of files, of the system. Their letters have to be in the
// fonts, whatever language they are in. The program's own are in the language's table.
#pragma once

#include <functional>
#include <string_view>

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

/// Each of them once or more often, in UTF-8 as far as whoever wrote it kept to that.
void forEachShownText(const Editor& editor, const UiState& ui,
                      const std::function<void(std::string_view text)>& visit);

}  // namespace anamorph
