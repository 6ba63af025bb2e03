#include "common/graphics/font.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "common/graphics/input_error.hpp"
#include "common/graphics/resource_manager.hpp"

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb_truetype.h>

namespace timestep {
namespace {

constexpr int k_side = 1024;
constexpr int k_shifts = 4;  // positions within a pixel

/// How far the halo reaches [pixels].
int halo_reach(float pixels) {
  return std::max(2, static_cast<int>(pixels * 0.2F));
}

/// A halo: each pixel takes the strongest ink within reach, less with the distance.
std::vector<std::uint8_t> halo_of(const std::vector<std::uint8_t>& ink, glm::ivec2 size,
                                  int reach) {
  std::vector<std::uint8_t> halo(ink.size());
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      float strongest = 0;
      for (int v = std::max(0, y - reach); v <= std::min(size.y - 1, y + reach); ++v) {
        for (int u = std::max(0, x - reach); u <= std::min(size.x - 1, x + reach);
             ++u) {
          const float far =
              std::hypot(static_cast<float>(u - x), static_cast<float>(v - y));
          const float share =
              std::clamp(2 - 2 * far / static_cast<float>(reach + 1), 0.0F, 1.0F);
          strongest = std::max(strongest,
                               share * ink[static_cast<std::size_t>(v * size.x + u)]);
        }
      }
      halo[static_cast<std::size_t>(y * size.x + x)] =
          static_cast<std::uint8_t>(strongest);
    }
  }
  return halo;
}

}  // namespace

struct Font::Info {
  std::string bytes;
  stbtt_fontinfo font{};
};

Font::Font(const std::filesystem::path& file) : info_(std::make_unique<Info>()) {
  std::ifstream stream(file, std::ios::binary);
  info_->bytes.assign(std::istreambuf_iterator<char>(stream), {});
  const auto* data = reinterpret_cast<const unsigned char*>(info_->bytes.data());
  if (info_->bytes.size() < 1024 || stbtt_InitFont(&info_->font, data, 0) == 0) {
    throw InputError(fmt::format("font {}: is missing or not a font", file.string()));
  }
}
Font::~Font() = default;
Font::Font(Font&&) noexcept = default;
Font& Font::operator=(Font&&) noexcept = default;

GlyphAtlas::GlyphAtlas() : texels_(static_cast<std::size_t>(2 * k_side) * k_side, 0) {
  fonts_.emplace_back(find_asset("fonts", "DejaVuSans.ttf"));
  fonts_.emplace_back(find_asset("fonts", "DejaVuSans-Bold.ttf"));
  glBindTexture(GL_TEXTURE_2D, texture_.id());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

const Glyph& GlyphAtlas::glyph(FontFace face, char32_t letter, float pixels,
                               float pen_x) {
  const float part = pen_x - std::floor(pen_x);
  const int shift = std::min(static_cast<int>(part * k_shifts), k_shifts - 1);
  const Key key{face, letter, static_cast<int>(std::lround(pixels * 4)), shift};
  if (const auto known = glyphs_.find(key); known != glyphs_.end())
    return known->second;

  const Font& font = fonts_[static_cast<std::size_t>(face)];
  const float offset = static_cast<float>(shift) / k_shifts;
  return glyphs_.emplace(key, bake(font.info(), letter, pixels, offset)).first->second;
}

float GlyphAtlas::advance(FontFace face, char32_t letter, float pixels) const {
  const stbtt_fontinfo& font = fonts_[static_cast<std::size_t>(face)].info().font;
  int advance = 0, bearing = 0;
  stbtt_GetCodepointHMetrics(&font, static_cast<int>(letter), &advance, &bearing);
  return static_cast<float>(advance) * stbtt_ScaleForMappingEmToPixels(&font, pixels);
}

Glyph GlyphAtlas::bake(const Font::Info& font, char32_t letter, float pixels,
                       float shift) {
  const float scale = stbtt_ScaleForMappingEmToPixels(&font.font, pixels);
  const int code = static_cast<int>(letter);
  glm::ivec2 low{0}, high{0};
  stbtt_GetCodepointBitmapBoxSubpixel(&font.font, code, scale, scale, shift, 0, &low.x,
                                      &low.y, &high.x, &high.y);
  if (high.x <= low.x || high.y <= low.y) return {};

  // Room for the halo all around; a new row when this one is full
  const int margin = halo_reach(pixels) + 1;
  const glm::ivec2 size = high - low + 2 * margin;
  if (pen_.x + size.x + 1 > k_side) {
    pen_ = {1, pen_.y + row_height_ + 1};
    row_height_ = 0;
  }
  if (size.x + 2 > k_side || pen_.y + size.y + 1 > k_side) return {};

  std::vector<std::uint8_t> ink(static_cast<std::size_t>(size.x * size.y), 0);
  stbtt_MakeCodepointBitmapSubpixel(
      &font.font, &ink[static_cast<std::size_t>(margin * size.x + margin)],
      high.x - low.x, high.y - low.y, size.x, scale, scale, shift, 0, code);
  const glm::ivec2 place = pen_;
  store(place, size, ink, halo_of(ink, size, margin - 1));
  pen_.x += size.x + 1;
  row_height_ = std::max(row_height_, size.y);
  return {place, size, low - margin};
}

void GlyphAtlas::store(glm::ivec2 place, glm::ivec2 size,
                       const std::vector<std::uint8_t>& ink,
                       const std::vector<std::uint8_t>& halo) {
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const auto from = static_cast<std::size_t>(y * size.x + x);
      const auto to =
          2 * static_cast<std::size_t>((place.y + y) * k_side + place.x + x);
      texels_[to] = ink[from];
      texels_[to + 1] = halo[from];
    }
  }
  changed_ = true;
}

void GlyphAtlas::bind() {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_.id());
  if (!changed_) return;
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RG8, k_side, k_side, 0, GL_RG, GL_UNSIGNED_BYTE,
               texels_.data());
  changed_ = false;
}

int GlyphAtlas::side() const {
  return k_side;
}

}  // namespace timestep
