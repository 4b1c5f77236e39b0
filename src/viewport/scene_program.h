// The programs of the 3D view: the shaders' constants come from C++ (shader_constants.inl), and the mirror's shape is
// one file of shaders/shapes.
#pragma once

#include <string>
#include <vector>

#include "gl/shader.h"

namespace anamorph {

/// What every shader of the view is made with; `shape`: its name in shaders/shapes.
ShaderOptions sceneOptions(const std::string& shape = "none", std::vector<std::string> defines = {});

/// A program that reads the scene block and the meshes' textures where surface_store.h puts them.
ShaderProgram makeSceneProgram(const std::string& vertexFile, const std::string& fragmentFile,
                               const ShaderOptions& options = sceneOptions());

}  // namespace anamorph
