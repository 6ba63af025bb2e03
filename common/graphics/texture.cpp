#include "common/graphics/texture.hpp"

#include <algorithm>

namespace timestep {

Texture::Texture(const Image& image) {
  // OpenGL's rows start at the bottom
  const auto row = static_cast<std::size_t>(image.width) * 4;
  std::vector<std::uint8_t> flipped;
  flipped.reserve(image.rgba.size());
  for (std::size_t end = image.rgba.size(); end >= row && row > 0; end -= row) {
    const auto last = image.rgba.begin() + static_cast<std::ptrdiff_t>(end);
    flipped.insert(flipped.end(), last - static_cast<std::ptrdiff_t>(row), last);
  }

  glBindTexture(GL_TEXTURE_2D, texture_.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA,
               GL_UNSIGNED_BYTE, flipped.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
}

void Texture::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture_.id());
}

}  // namespace timestep
