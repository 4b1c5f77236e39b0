// Freezing a sculpture: from then on it stays as it is, while eye, original and mirror move without it, and the match
// shows what it is still worth. Not the sculpture is kept but what it was made from, which is small and gives every vertex
// again to the last bit.
//
//      follows:  eye, mirror, original, k  ----------------> sculpture
//      frozen:   those of the moment of freezing (frozen) -> sculpture      the level's own: seen, traced, compared
#pragma once

#include "level/level.h"

namespace anamorph {

/// What the level's sculpture is made from: what was kept when it was frozen, else the level's own.
SculptureInputs sculptureInputs(const LevelScene& level);

/// Whether the original stands elsewhere than the frozen sculpture was made from.
bool hasOriginalMoved(const LevelScene& level);

/// The level as it was, in all that the sculpture is made from: how a frozen one has to be set up to be right.
Level asMade(Level level);

/// The sculpture stays as it is from now on. A level that is frozen already stays the same.
Level frozen(Level level);
/// The sculpture is made from the level's own eye, mirror and original again.
Level following(Level level);

}  // namespace anamorph
