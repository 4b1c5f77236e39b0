// The texts of strangers that the window may show: of levels, of files, of the system. Their letters have to be in the
// fonts, whatever language they are in. The program's own are in the language's table.
#pragma once

#include <functional>
#include <string_view>

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

/// Those of a level: long ones, so only when they have changed. Of the lesson the JSON text, which has them all in it.
void forEachTextOf(const LevelText& level, const std::function<void(std::string_view text)>& visit);

/// All others, each once or more often, in UTF-8 as far as whoever wrote it kept to that.
void forEachShownText(const Editor& editor, const UiState& ui,
                      const std::function<void(std::string_view text)>& visit);

}  // namespace anamorph
