// A name in a file chooses by its place in the list of names: an enumerator, or the alternative of a variant.
#pragma once

#include <cstddef>
#include <type_traits>
#include <variant>

namespace anamorph {

template <typename Enum>
requires std::is_enum_v<Enum>
void choose(Enum& value, std::size_t index) {
  value = static_cast<Enum>(index);
}

/// The alternative begins with its defaults; for an index beyond the last one nothing changes.
template <typename... Alternative>
void choose(std::variant<Alternative...>& value, std::size_t index) {
  std::size_t i = 0;
  ((i++ == index ? static_cast<void>(value.template emplace<Alternative>()) : void()), ...);
}

}  // namespace anamorph
