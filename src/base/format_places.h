// The places of a text that values are put into, as fmt reads them: "{} of {:.1f}" has two. A translation has to have
// the same ones; it may number them, "{1} von {0}", where its words go another way.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace anamorph {

/// The number of the value and how it is written: {0, ""}, {1, ".1f"}.
using FormatPlaces = std::set<std::pair<std::size_t, std::string>>;

/// Nothing for a text that is no format: a brace that stands alone ("{{" means one), places that are named, numbered
/// and not, or that contain others.
std::optional<FormatPlaces> findFormatPlaces(std::string_view text);

/// Whether values that go into the English text go into the other one, too. True of an English text that is no format.
bool takesSameValues(std::string_view english, std::string_view translation);

}  // namespace anamorph
