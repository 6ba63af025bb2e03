#include "common/graphics/symbol_batch.hpp"

#include "common/graphics/palette.hpp"
#include "common/graphics/pixels.hpp"

namespace timestep {
namespace {

// After the marker shapes, which symbol.frag knows by their numbers
constexpr float k_panel_shape = 8;
static_assert(static_cast<int>(MarkerShape::ring) == 7);

}  // namespace

SymbolBatch::SymbolBatch(ResourceManager& resources)
    : shader_(resources.load_shader("symbol.vert", "symbol.frag")),
      quads_(sizeof(Symbol), {{1, 4, offsetof(Symbol, clip)},
                              {2, 4, offsetof(Symbol, fill)},
                              {3, 4, offsetof(Symbol, border)},
                              {4, 4, offsetof(Symbol, half_size)}}) {}

void SymbolBatch::add(const Marker& marker, const Frame& frame) {
  const glm::vec4 clip = toward_eye(frame, marker.position, 0.02F);
  if (!is_finite(clip) || clip.w <= 0) return;
  symbols_.push_back({clip, marker.style.color, k_paper,
                      glm::vec2(marker.size * frame.scale / 2), 1.3F * frame.scale,
                      static_cast<float>(marker.style.marker)});
}

void SymbolBatch::add_flat(glm::vec2 center, const Style& style, float size,
                           const Frame& frame) {
  symbols_.push_back({clip_from_pixel(frame, center), style.color, k_paper,
                      glm::vec2(size / 2), 1.1F * frame.scale,
                      static_cast<float>(style.marker)});
}

void SymbolBatch::add_panel(glm::vec2 top_left, glm::vec2 size, const Frame& frame) {
  Color fill = k_paper, border = k_muted;
  fill.a = 0.93F;
  border.a = 0.22F;
  symbols_.push_back({clip_from_pixel(frame, top_left + size / 2.0F), fill, border,
                      size / 2.0F, frame.scale, k_panel_shape});
}

void SymbolBatch::draw(const Frame& frame) {
  quads_.upload(std::span<const Symbol>(symbols_));
  shader_.set("half_size", frame.size / 2.0F);
  quads_.draw(symbols_.size());
}

}  // namespace timestep
