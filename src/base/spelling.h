// "Did you mean ...?": the known word that a misspelt one is nearest to.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace anamorph {

/// The nearest of the known words by letters left out, added, changed and swapped, whatever their case; "" when none is
/// near enough to be meant.
std::string nearestWord(std::string_view word, const std::vector<std::string>& known);

/// "; did you mean "radius"?", or nothing.
std::string didYouMean(std::string_view word, const std::vector<std::string>& known);

}  // namespace anamorph
