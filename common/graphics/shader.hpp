/// @file
/// A program for the graphics card, from a vertex and a fragment shader.
#pragma once

#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "common/graphics/gl_handle.hpp"

namespace timestep {

/// The source of one stage, and for messages the names of the files it came from: the
/// stage's own, and the one that it includes, if any, whose lines OpenGL counts as
/// those of source string 1.
struct ShaderSource {
  std::string file, text, included;
};

/// A linked program. Errors in the source throw InputError with file and line.
class Shader {
 public:
  Shader(const ShaderSource& vertex, const ShaderSource& fragment);

  /// Makes this the program that draws.
  void bind() const;

  /// Binds this and sets its uniform; names that it does not use are ignored.
  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  void set(const char* name, glm::vec2 value) const;
  void set(const char* name, glm::vec3 value) const;
  void set(const char* name, const glm::vec4& value) const;
  void set(const char* name, const glm::mat4& value) const;

 private:
  GLint location(const char* name) const;

  ProgramHandle program_;
};

/// The text of a shader that was embedded in the executable, as `assets/shaders/` had
/// it at build time; empty if there is none of this name.
std::string_view embedded_shader(std::string_view file);

}  // namespace timestep
