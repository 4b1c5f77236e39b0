// A guess at which way is up in a model whose file does not say it. What tells, the first that does:
//
//   the program that wrote an OBJ, by its comment    Blender, Maya, Rhino: y;  FreeCAD, OpenSCAD: z
//   an STL                                           z, the direction in which it is printed
//   a flat underside                                 of the box's side, seen along y or z
//   the larger extent                                of y and z
#pragma once

#include <string>
#include <string_view>

#include "geometry/mesh_formats.h"
#include "geometry/model_up.h"

namespace anamorph {

struct UpGuess {
  enum class Reason { program, printing, underside, extent, nothing };
  ModelUp up = ModelUp::z;
  Reason reason = Reason::nothing;
  const char* program = "";  ///< for Reason::program

  bool operator==(const UpGuess& other) const {
    return up == other.up && reason == other.reason && std::string_view(program) == other.program;
  }
};

/// Always z or y. `mesh` is as the file `bytes` has it.
UpGuess guessUp(const Mesh& mesh, MeshFormat format, std::string_view bytes);

/// The guess and why, as a sentence.
std::string upGuessText(const UpGuess& guess);

}  // namespace anamorph
