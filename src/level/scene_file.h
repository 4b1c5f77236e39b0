// The scene files of the thesis (appendix A) and of its framework: "Eye" and "Objects", of which one is the
// mirror ("quad", "cylinder" or "sphere") and one tells where the mesh stands. Read as they are, the same keys
// in the same case, as strictly as a level. They are never written.
#pragma once

#include "level/field_reader.h"
#include "level/json.h"
#include "level/level.h"

namespace anamorph {

/// Whether it has the keys of a scene file and is no level.
bool isThesisScene(const JsonValue& document);

/// The level of a scene file. It still needs a model: the original is a FileShape without a path, placed at
/// the mesh's position, which the camera looks at. Keys that are not known are noted in the context. Throws
/// Error.
Level readThesisScene(const JsonValue& document, FieldReader::Context& context);

}  // namespace anamorph
