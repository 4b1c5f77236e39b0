// Shader programs from the files of shaders/. A file may say `#include "other.glsl"` (each file comes in
// once), or `#include NAME` when whoever makes the program chooses the file. The version line, precisions and what
// the caller gives are put in front, so one source serves OpenGL 3.3 and OpenGL ES 3.0. Complaints of the compiler
// are told with the file and the line of that file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace anamorph {

enum class Dialect {
  desktop,  ///< #version 330 core
  es,       ///< #version 300 es
};

enum class ShaderStage { vertex, fragment };

/// A source with its includes in place. Piece i of the compiler's "string number" is file i.
struct ShaderText {
  std::string text;
  std::vector<std::filesystem::path> files;
};

/// What a program is made with, beside its files.
struct ShaderOptions {
  std::string prelude;                          ///< GLSL in front of everything
  std::vector<std::string> defines;             ///< texts to #define
  std::map<std::string, std::string> includes;  ///< which file `#include NAME` is
};

/// Reads `folder`/`name` and what it includes. Throws Error for a missing file.
ShaderText loadShaderText(const std::filesystem::path& folder, const std::string& name, Dialect dialect,
                          const ShaderOptions& options = {});

/// What the compiler says with the numbers of files replaced by their names; empty when all is well. `text`
/// need not be from a file.
std::string compileProblem(const ShaderText& text, ShaderStage stage);

/// A linked program. Moved, not copied.
class ShaderProgram {
 public:
  ShaderProgram() = default;
  /// From two files of resourceFolder()/shaders. Throws Error.
  ShaderProgram(const std::string& vertexFile, const std::string& fragmentFile,
                const ShaderOptions& options = {});
  ~ShaderProgram();
  ShaderProgram(ShaderProgram&& other) noexcept;
  ShaderProgram& operator=(ShaderProgram&& other) noexcept;

  bool empty() const { return name_ == 0; }
  void use() const;
  /// Of the program in use; a name that the program does not have is ignored (compilers drop what is not
  /// needed).
  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  void set(const char* name, float x, float y) const;
  void set(const char* name, float x, float y, float z, float w) const;
  /// Which binding point a uniform block reads.
  void bindBlock(const char* name, int point) const;

 private:
  int locationOf(const char* name) const;

  std::uint32_t name_ = 0;
};

/// Uniforms shared by programs: a buffer that is written as a whole and read at a binding point.
class UniformBuffer {
 public:
  explicit UniformBuffer(int point);
  ~UniformBuffer();
  UniformBuffer(const UniformBuffer&) = delete;
  UniformBuffer& operator=(const UniformBuffer&) = delete;

  void write(const void* data, std::size_t size);
  /// Programs read this one from now on, as after write().
  void bind() const;

 private:
  std::uint32_t name_ = 0;
  int point_;
};

}  // namespace anamorph
