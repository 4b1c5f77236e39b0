// Which axis of a model points up. Here that is z, as in files for 3D printers; most programs that make pictures or games
// have y up, so that their models come in lying on their backs. A file shape says which one it is, and its mesh is turned
// as soon as it is read: everything after that has z up.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include <glm/mat3x3.hpp>

#include "geometry/mesh.h"

namespace anamorph {

enum class ModelUp { z, y, minusY, x };

/// In levels, on the command line and in the panels, in the order of ModelUp.
inline constexpr std::array modelUpNames{"z", "y", "-y", "x"};

constexpr const char* modelUpName(ModelUp up) {
  return modelUpNames[static_cast<std::size_t>(up)];
}

/// Nothing for another name.
std::optional<ModelUp> findModelUp(std::string_view name);

/// The quarter turn that makes this axis z.
glm::dmat3 uprightRotation(ModelUp up);

/// The mesh of a model whose `up` points up, with z up.
Mesh standUp(Mesh mesh, ModelUp up);

}  // namespace anamorph
