#include "common/graphics/text_batch.hpp"

#include <cmath>

#include "common/graphics/palette.hpp"

namespace timestep {

TextBatch::TextBatch(ResourceManager& resources)
    : shader_(resources.load_shader("text.vert", "text.frag")),
      quads_(sizeof(Letter), {{1, 4, offsetof(Letter, place)},
                              {2, 4, offsetof(Letter, source)},
                              {3, 4, offsetof(Letter, color)}}) {}

void TextBatch::add(std::string_view text, glm::vec2 pen, const TextStyle& style) {
  pen.y = std::round(pen.y);
  for (const char32_t letter : decode_utf8(text)) {
    const Glyph& glyph = atlas_.glyph(style.face, letter, style.size, pen.x);
    if (glyph.size.x > 0) {
      const glm::vec2 place = glm::vec2(std::floor(pen.x), pen.y) + glyph.offset;
      letters_.push_back({place, glyph.size, glyph.source, glyph.size, style.color});
    }
    pen.x += atlas_.advance(style.face, letter, style.size);
  }
}

float TextBatch::width(std::string_view text, const TextStyle& style) const {
  float width = 0;
  for (const char32_t letter : decode_utf8(text)) {
    width += atlas_.advance(style.face, letter, style.size);
  }
  return width;
}

void TextBatch::draw(const Frame& frame) {
  if (letters_.empty()) return;
  quads_.upload(std::span<const Letter>(letters_));
  atlas_.bind();
  shader_.set("half_size", frame.size / 2.0F);
  shader_.set("atlas", 0);
  shader_.set("atlas_side", static_cast<float>(atlas_.side()));
  shader_.set("halo", glm::vec3(k_paper));

  // All halos lie below all letters
  for (const int halo_pass : {1, 0}) {
    shader_.set("halo_pass", halo_pass);
    quads_.draw(letters_.size());
  }
}

}  // namespace timestep
