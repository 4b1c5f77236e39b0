// How much memory the levels of a history take, and what they can share: the words of a level may be a megabyte of lesson,
// while a drag changes three numbers.
#pragma once

#include <cstddef>
#include <span>

#include "level/level.h"

namespace anamorph {

/// Bytes that the levels keep in memory, those behind pointers too; what several of them share counts once.
std::size_t bytesOf(std::span<const Level> levels);

/// How many of the newest levels, which are the last ones, take no more than this together; one at least where there is
/// any.
std::size_t countWithin(std::span<const Level> levels, std::size_t bytes);

/// Lets go of what is quickly made again when the level is shown again.
void dropCutSurfaces(Level& level);

/// Where one of the others has equal words, the level shares them from then on.
void shareText(Level& level, std::span<const Level> others);

}  // namespace anamorph
