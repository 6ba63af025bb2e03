/// @file
/// Text on the picture, with a soft halo so that it reads on anything.
#pragma once

#include <string_view>
#include <vector>

#include "common/graphics/font.hpp"
#include "common/graphics/frame.hpp"
#include "common/graphics/quads.hpp"
#include "common/graphics/resource_manager.hpp"

namespace timestep {

/// How text is drawn; `size` is the em in the picture's own pixels.
struct TextStyle {
  float size = 14;
  Color color{0, 0, 0, 1};
  FontFace face = FontFace::regular;
};

/// Collects text, then draws it all at once.
class TextBatch {
 public:
  explicit TextBatch(ResourceManager& resources);

  void clear() { letters_.clear(); }

  /// Text whose base line starts at `pen`; pixels from the top left corner.
  void add(std::string_view text, glm::vec2 pen, const TextStyle& style);

  /// Its width [pixels].
  float width(std::string_view text, const TextStyle& style) const;

  void draw(const Frame& frame);

 private:
  struct Letter {
    glm::vec2 place, size, source, source_size;
    Color color;
  };

  const Shader& shader_;
  GlyphAtlas atlas_;
  Quads quads_;
  std::vector<Letter> letters_;
};

}  // namespace timestep
