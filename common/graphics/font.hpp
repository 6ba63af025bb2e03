/// @file
/// Letters as small pictures, made from a TrueType font at the size they are needed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string_view>
#include <tuple>
#include <vector>

#include <glm/glm.hpp>

#include "common/graphics/gl_handle.hpp"

namespace timestep {

enum class FontFace { regular, bold };

/// Where a letter's picture is in the atlas, and where it goes. Pixels.
struct Glyph {
  glm::vec2 source{0}, size{0};
  glm::vec2 offset{0};  ///< from the pen on the base line to the picture's top left
};

/// A TrueType file in memory.
class Font {
 public:
  /// Throws InputError if the file is missing or not a font.
  explicit Font(const std::filesystem::path& file);
  ~Font();
  Font(Font&&) noexcept;
  Font& operator=(Font&&) noexcept;

  struct Info;
  const Info& info() const { return *info_; }

 private:
  std::unique_ptr<Info> info_;
};

/// A texture of all letters met so far: red is the letter, green a soft halo around it.
/// Each is made once for a size and a quarter of a pixel, so that text is evenly
/// spaced.
class GlyphAtlas {
 public:
  GlyphAtlas();

  /// The letter for a code point at `pixels` a line's height, the pen at `pen_x`.
  const Glyph& glyph(FontFace face, char32_t letter, float pixels, float pen_x);

  /// How far the pen moves after a letter.
  float advance(FontFace face, char32_t letter, float pixels) const;

  /// Binds the texture to unit 0, brought up to date.
  void bind();

  int side() const;

 private:
  using Key = std::tuple<FontFace, char32_t, int, int>;

  Glyph bake(const Font::Info& font, char32_t letter, float pixels, float shift);
  void store(glm::ivec2 place, glm::ivec2 size, const std::vector<std::uint8_t>& ink,
             const std::vector<std::uint8_t>& halo);

  std::vector<Font> fonts_;
  std::map<Key, Glyph> glyphs_;
  std::vector<std::uint8_t> texels_;
  glm::ivec2 pen_{1};  ///< where the next letter's picture goes
  int row_height_ = 0;
  bool changed_ = true;
  TextureHandle texture_;
};

/// The code points of a UTF-8 text; a broken byte becomes U+FFFD.
std::u32string decode_utf8(std::string_view text);

}  // namespace timestep
