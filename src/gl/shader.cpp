#include "gl/shader.h"

#include <algorithm>
#include <regex>
#include <sstream>
#include <utility>

#include <glad/gl.h>

#include "base/error.h"
#include "base/file.h"
#include "base/resources.h"

namespace anamorph {
namespace {

constexpr std::size_t maxShaderBytes = 1 << 20;

const char* preamble(Dialect dialect) {
  if (dialect == Dialect::desktop) return "#version 330 core\n";
  return "#version 300 es\n"
         "precision highp float;\n"
         "precision highp int;\n"
         "precision highp sampler2D;\n"
         "precision highp usampler2D;\n";
}

// `#line N F`: the next line is line N of file F.
class Assembler {
 public:
  Assembler(std::filesystem::path folder, const ShaderOptions& options, ShaderText& result)
      : folder_(std::move(folder)), options_(options), result_(result) {}

  void add(const std::string& name) {
    const std::filesystem::path path = folder_ / name;
    if (std::find(result_.files.begin(), result_.files.end(), path) != result_.files.end()) return;
    const std::size_t number = result_.files.size();
    result_.files.push_back(path);
    std::istringstream source(std::string(readFile(path, maxShaderBytes).view()));
    const auto here = [&](int line) {
      result_.text += "#line " + std::to_string(line) + ' ' + std::to_string(number) + '\n';
    };
    here(1);
    static const std::regex include(R"re(\s*#include\s+(?:"([^"]+)"|(\w+))\s*)re");
    std::smatch match;
    int lineNumber = 1;
    for (std::string line; std::getline(source, line); ++lineNumber) {
      if (std::regex_match(line, match, include)) {
        add(match[1].matched ? match[1].str() : chosen(match[2], path));
        here(lineNumber + 1);
      } else {
        result_.text += line + '\n';
      }
    }
  }

 private:
  const std::string& chosen(const std::string& name, const std::filesystem::path& path) const {
    const auto found = options_.includes.find(name);
    if (found == options_.includes.end()) throw Error("no file is given for #include " + name, path.string());
    return found->second;
  }

  std::filesystem::path folder_;
  const ShaderOptions& options_;
  ShaderText& result_;
};

std::string logOf(GLuint object, bool isProgram) {
  GLint length = 0;
  isProgram ? glGetProgramiv(object, GL_INFO_LOG_LENGTH, &length)
            : glGetShaderiv(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  GLsizei written = 0;
  isProgram ? glGetProgramInfoLog(object, length, &written, log.data())
            : glGetShaderInfoLog(object, length, &written, log.data());
  log.resize(static_cast<std::size_t>(std::max(written, 0)));
  while (!log.empty() && (log.back() == '\n' || log.back() == '\0')) log.pop_back();
  return log;
}

// Mesa begins its lines with "1:23(4): error", NVIDIA with "1(23) : error", others with "ERROR: 1:23: ".
std::string withFileNames(const std::string& log, const std::vector<std::filesystem::path>& files) {
  static const std::regex place(R"(^(ERROR: |WARNING: )?(\d+)(:(\d+)|\((\d+)\))(\(\d+\))?)");
  std::istringstream lines(log);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_search(line, match, place)) {
      const std::size_t file = std::stoul(match[2]);
      const std::string number = match[4].matched ? match[4] : match[5];
      if (file < files.size()) {
        line = files[file].filename().string() + ':' + number + match.suffix().str();
      }
    }
    result += (result.empty() ? "" : "\n") + line;
  }
  return result;
}

/// Null, and `problem` says why, when it does not compile.
GLuint compile(const ShaderText& text, ShaderStage stage, std::string& problem) {
  const GLuint shader = glCreateShader(stage == ShaderStage::vertex ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
  const char* source = text.text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled) return shader;
  problem = withFileNames(logOf(shader, false), text.files);
  if (problem.empty()) problem = "the compiler gives no reason";
  glDeleteShader(shader);
  return 0;
}

GLuint compileFile(const std::string& name, ShaderStage stage, const ShaderOptions& options) {
  const std::filesystem::path folder = resourceFolder() / "shaders";
  std::string problem;
  const GLuint shader = compile(loadShaderText(folder, name, Dialect::desktop, options), stage, problem);
  if (shader == 0) throw Error("the shader does not compile: " + problem, (folder / name).string());
  return shader;
}

}  // namespace

ShaderText loadShaderText(const std::filesystem::path& folder, const std::string& name, Dialect dialect,
                          const ShaderOptions& options) {
  ShaderText result{preamble(dialect), {}};
  for (const std::string& define : options.defines) result.text += "#define " + define + '\n';
  result.text += options.prelude;
  Assembler(folder, options, result).add(name);
  return result;
}

std::string compileProblem(const ShaderText& text, ShaderStage stage) {
  std::string problem;
  glDeleteShader(compile(text, stage, problem));
  return problem;
}

ShaderProgram::ShaderProgram(const std::string& vertexFile, const std::string& fragmentFile,
                             const ShaderOptions& options) {
  const GLuint vertex = compileFile(vertexFile, ShaderStage::vertex, options);
  const GLuint fragment = compileFile(fragmentFile, ShaderStage::fragment, options);
  name_ = glCreateProgram();
  for (const GLuint shader : {vertex, fragment}) {
    glAttachShader(name_, shader);
    glDeleteShader(shader);  // when the program goes
  }
  glLinkProgram(name_);
  GLint linked = 0;
  glGetProgramiv(name_, GL_LINK_STATUS, &linked);
  if (linked) return;
  const std::string problem = logOf(name_, true);
  glDeleteProgram(name_);
  throw Error("the shaders do not fit together: " + problem, vertexFile + " and " + fragmentFile);
}

// One in use is deleted only when another one is: who notes it and puts it back meanwhile would name one that is gone.
ShaderProgram::~ShaderProgram() {
  if (name_ == 0) return;
  GLint current = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &current);
  if (current == static_cast<GLint>(name_)) glUseProgram(0);
  glDeleteProgram(name_);
}

ShaderProgram::ShaderProgram(ShaderProgram&& other) noexcept : name_(std::exchange(other.name_, 0)) {}

ShaderProgram& ShaderProgram::operator=(ShaderProgram&& other) noexcept {
  std::swap(name_, other.name_);
  return *this;
}

void ShaderProgram::use() const {
  glUseProgram(name_);
}

int ShaderProgram::locationOf(const char* name) const {
  return glGetUniformLocation(name_, name);
}

void ShaderProgram::set(const char* name, int value) const {
  glUniform1i(locationOf(name), value);
}

void ShaderProgram::set(const char* name, float value) const {
  glUniform1f(locationOf(name), value);
}

void ShaderProgram::set(const char* name, float x, float y) const {
  glUniform2f(locationOf(name), x, y);
}

void ShaderProgram::set(const char* name, float x, float y, float z, float w) const {
  glUniform4f(locationOf(name), x, y, z, w);
}

void ShaderProgram::bindBlock(const char* name, int point) const {
  const GLuint index = glGetUniformBlockIndex(name_, name);
  if (index != GL_INVALID_INDEX) glUniformBlockBinding(name_, index, static_cast<GLuint>(point));
}

UniformBuffer::UniformBuffer(int point) : point_(point) {
  glGenBuffers(1, &name_);
}

UniformBuffer::~UniformBuffer() {
  glDeleteBuffers(1, &name_);
}

void UniformBuffer::write(const void* data, std::size_t size) {
  glBindBuffer(GL_UNIFORM_BUFFER, name_);
  glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(size), data, GL_STREAM_DRAW);
  bind();
}

void UniformBuffer::bind() const {
  glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(point_), name_);
}

}  // namespace anamorph
