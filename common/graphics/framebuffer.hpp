/// @file
/// Pictures to draw into that are not on the screen.
#pragma once

#include <glm/glm.hpp>

#include "common/graphics/gl_handle.hpp"
#include "common/graphics/image.hpp"

namespace timestep {

/// A colour and depth buffer with several samples a pixel.
class Framebuffer {
 public:
  /// As many samples as asked for or as the driver has. Throws InputError if the driver
  /// cannot make one of this size.
  Framebuffer(glm::ivec2 size, int samples);

  /// Draws go here from now on; clears it and sets the viewport.
  void begin() const;

  /// The samples averaged, rows from the top.
  Image read() const;

  glm::ivec2 size() const { return size_; }

 private:
  glm::ivec2 size_;
  RenderbufferHandle color_, depth_, resolved_color_;
  FramebufferHandle multisampled_, resolved_;
};

/// Depths as seen from the light, to be compared with in shaders.
class ShadowMap {
 public:
  /// `side` pixels a side.
  explicit ShadowMap(int side);

  /// Depths are drawn here until the next framebuffer is bound; clears it.
  void begin() const;

  /// Binds it as a `sampler2DShadow` to a texture unit.
  void bind(int unit) const;

 private:
  int side_;
  TextureHandle depth_;
  FramebufferHandle framebuffer_;
};

}  // namespace timestep
