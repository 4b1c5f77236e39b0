// Scripts whose letters change their shape and order with their neighbours. Dear ImGui puts one letter after the other
// from left to right, so these would be wrong to read: they are not drawn, and it is said why.
#pragma once

namespace anamorph {

/// The name of the script, in English, when the letter is of such a one; else null.
const char* findShapedScript(char32_t letter);

}  // namespace anamorph
