#include "common/graphics/shader.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include "common/graphics/input_error.hpp"

namespace timestep {
namespace {

struct StageKind {
  static GLuint create() { return 0; }
  static void destroy(GLuint id) { glDeleteShader(id); }
};

/// The compiler's first complaint as "FILE:LINE: …". Drivers write source string and
/// line as "0:12(3): error: …" (Mesa), "0(12) : error …" (NVIDIA) or "ERROR: 0:12: …".
std::string complaint(const ShaderSource& source, const std::string& log) {
  const std::string first = log.substr(0, log.find('\n'));
  const std::size_t place = first.find_first_of("0123456789");
  unsigned string = 0, line = 0;
  if (place == std::string::npos
      || std::sscanf(&first[place], "%u%*1[:(]%u", &string, &line) != 2) {
    return fmt::format("shader {}: {}", source.file, first);
  }
  const std::size_t reason = first.find(": ", place);
  return fmt::format("shader {}:{}{}", string == 1 ? source.included : source.file,
                     line, reason == std::string::npos ? "" : first.substr(reason));
}

/// Compiles one stage into `stage`, which the caller deletes.
void compile(GLuint stage, const ShaderSource& source) {
  const char* text = source.text.c_str();
  glShaderSource(stage, 1, &text, nullptr);
  glCompileShader(stage);

  GLint compiled = 0;
  glGetShaderiv(stage, GL_COMPILE_STATUS, &compiled);
  if (compiled != 0) return;
  std::string log(4096, '\0');
  GLsizei length = 0;
  glGetShaderInfoLog(stage, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  throw InputError(complaint(source, log));
}

struct VertexStageKind : StageKind {
  static GLuint create() { return glCreateShader(GL_VERTEX_SHADER); }
};
struct FragmentStageKind : StageKind {
  static GLuint create() { return glCreateShader(GL_FRAGMENT_SHADER); }
};

}  // namespace

Shader::Shader(const ShaderSource& vertex, const ShaderSource& fragment) {
  const GlHandle<VertexStageKind> vertex_stage;
  const GlHandle<FragmentStageKind> fragment_stage;
  compile(vertex_stage.id(), vertex);
  compile(fragment_stage.id(), fragment);

  const GLuint program = program_.id();
  glAttachShader(program, vertex_stage.id());
  glAttachShader(program, fragment_stage.id());
  glLinkProgram(program);
  glDetachShader(program, vertex_stage.id());
  glDetachShader(program, fragment_stage.id());

  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked != 0) return;
  std::string log(4096, '\0');
  GLsizei length = 0;
  glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  throw InputError(fmt::format("shaders {} and {}: {}", vertex.file, fragment.file,
                               log.substr(0, log.find('\n'))));
}

void Shader::bind() const {
  glUseProgram(program_.id());
}

GLint Shader::location(const char* name) const {
  bind();
  return glGetUniformLocation(program_.id(), name);
}

void Shader::set(const char* name, int value) const {
  glUniform1i(location(name), value);
}
void Shader::set(const char* name, float value) const {
  glUniform1f(location(name), value);
}
void Shader::set(const char* name, glm::vec2 value) const {
  glUniform2f(location(name), value.x, value.y);
}
void Shader::set(const char* name, glm::vec3 value) const {
  glUniform3f(location(name), value.x, value.y, value.z);
}
void Shader::set(const char* name, const glm::vec4& value) const {
  glUniform4f(location(name), value.x, value.y, value.z, value.w);
}
void Shader::set(const char* name, const glm::mat4& value) const {
  glUniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace timestep
