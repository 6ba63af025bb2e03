/// @file
/// Owns one OpenGL object's name; gives it back when it goes.
#pragma once

#include <utility>

#include <epoxy/gl.h>

namespace timestep {

/// A move-only owner. `Kind` has static functions `create()` and `destroy(GLuint)`. The
/// context in which it was made must be current when it is destroyed.
template <class Kind>
class GlHandle {
 public:
  GlHandle() : id_(Kind::create()) {}
  ~GlHandle() {
    if (id_ != 0) Kind::destroy(id_);
  }
  GlHandle(GlHandle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  GlHandle& operator=(GlHandle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  GlHandle(const GlHandle&) = delete;
  GlHandle& operator=(const GlHandle&) = delete;

  GLuint id() const { return id_; }

 private:
  GLuint id_;
};

struct BufferKind {
  static GLuint create() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
};

struct VertexArrayKind {
  static GLuint create() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
};

struct TextureKind {
  static GLuint create() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};

struct FramebufferKind {
  static GLuint create() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};

struct RenderbufferKind {
  static GLuint create() {
    GLuint id = 0;
    glGenRenderbuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteRenderbuffers(1, &id); }
};

struct ProgramKind {
  static GLuint create() { return glCreateProgram(); }
  static void destroy(GLuint id) { glDeleteProgram(id); }
};

using BufferHandle = GlHandle<BufferKind>;
using VertexArrayHandle = GlHandle<VertexArrayKind>;
using TextureHandle = GlHandle<TextureKind>;
using FramebufferHandle = GlHandle<FramebufferKind>;
using RenderbufferHandle = GlHandle<RenderbufferKind>;
using ProgramHandle = GlHandle<ProgramKind>;

}  // namespace timestep
