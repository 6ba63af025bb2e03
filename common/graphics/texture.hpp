/// @file
/// An image on the graphics card.
#pragma once

#include "common/graphics/gl_handle.hpp"
#include "common/graphics/image.hpp"

namespace timestep {

/// A colour texture with mipmaps, repeating; its v axis runs up from the bottom row.
class Texture {
 public:
  explicit Texture(const Image& image);

  /// Binds it to a texture unit, from 0.
  void bind(int unit) const;

 private:
  TextureHandle texture_;
};

}  // namespace timestep
