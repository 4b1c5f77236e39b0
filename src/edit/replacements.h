// Something else in the original's place: about as large as the old one, and where that was. (Of the mirror:
// level/mirror_kind.h, mirror_import.h.)
#pragma once

#include "geometry/mesh.h"
#include "level/level.h"
#include "math/box.h"

namespace anamorph {

/// The factor by which `own` fits `room`; 1 when a level has no room for such a scale.
double scaleInto(const Box& own, const Box& room);

/// A built-in original by the index of its alternative in OriginalShape, at its usual size.
OriginalShape builtInShape(std::size_t kind);

/// `shape` for an original: as large as fits `box`, the one of the placed old original, and centred in it,
/// upright. `mesh` is what the shape is before it is placed. Without a box or points it stands where the old
/// one stood. A built-in shape gets another size rather than a scale; a box fills the old box. A frozen sculpture
/// follows again.
Level withOriginal(const Level& level, OriginalShape shape, const Mesh& mesh, const Box& box);

/// Another mesh file for the one that the original is, with the rotation that it has, and with its scale as long as that
/// makes the new one half to twice as large as fits `box`; else as large as fits. Centred in the box, as above.
Level withAnotherMesh(const Level& level, FileShape file, const Mesh& mesh, const Box& box);

/// The same as withOriginal() for a built-in shape, whose mesh can be made at once.
Level withBuiltInOriginal(const Level& level, std::size_t kind, const Box& box);

/// Room for an original whose own size nobody knows: where the RT camera looks, half as high as its picture.
Box roomInSight(const Level& level);

/// A pawn in that room.
Level withStandIn(const Level& level);

}  // namespace anamorph
