/// @file
/// Markers and panels: flat shapes that face the viewer.
#pragma once

#include <vector>

#include "common/graphics/frame.hpp"
#include "common/graphics/quads.hpp"
#include "common/graphics/resource_manager.hpp"

namespace timestep {

/// Collects symbols, then draws them all at once, in order.
class SymbolBatch {
 public:
  explicit SymbolBatch(ResourceManager& resources);

  void clear() { symbols_.clear(); }

  /// A marker in the scene.
  void add(const Marker& marker, const Frame& frame);

  /// A marker on the picture; pixels from the top left corner, size in pixels.
  void add_flat(glm::vec2 center, const Style& style, float size, const Frame& frame);

  /// A panel with round corners; pixels from the top left corner.
  void add_panel(glm::vec2 top_left, glm::vec2 size, const Frame& frame);

  void draw(const Frame& frame);

 private:
  struct Symbol {
    glm::vec4 clip;
    Color fill, border;
    glm::vec2 half_size;
    float border_width, shape;
  };

  const Shader& shader_;
  Quads quads_;
  std::vector<Symbol> symbols_;
};

}  // namespace timestep
