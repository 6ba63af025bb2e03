/// @file
/// Smooth lines of any width, dashed or fading, in the scene or flat on the picture.
#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "common/graphics/frame.hpp"
#include "common/graphics/quads.hpp"
#include "common/graphics/resource_manager.hpp"

namespace timestep {

/// How a line is drawn; widths in the picture's own pixels.
struct Stroke {
  Color color{0, 0, 0, 1};
  float width = 2;
  Dash dash = Dash::solid;
  bool fade = false;  ///< the first point is transparent
};

/// Collects lines, then draws them all at once. Points that are not finite break a
/// line.
class LineBatch {
 public:
  explicit LineBatch(ResourceManager& resources);

  void clear() { points_.clear(); }

  /// A line in the scene.
  void add(std::span<const glm::vec3> world, const Stroke& stroke, const Frame& frame);

  /// A line on the picture; pixels from the top left corner.
  void add_flat(std::span<const glm::vec2> pixels, const Stroke& stroke,
                const Frame& frame);

  /// A shaft with a head; `width` is the shaft's.
  void add_arrow(const Arrow& arrow, const Frame& frame);

  void draw(const Frame& frame);

 private:
  /// Half the width is negative where the line is broken.
  struct Point {
    glm::vec4 clip;
    Color color;
    float half_width, length, dash, gap;
  };

  void add_clip(std::span<const glm::vec4> clip, const Stroke& stroke,
                const Frame& frame);
  void add_run(std::span<const glm::vec4> clip, std::span<const float> alphas,
               const Stroke& stroke, const Frame& frame);
  void add_tapered(glm::vec4 from, glm::vec4 to, float from_width, float to_width,
                   const Color& color);
  void add_break(const Point& beside);

  const Shader& shader_;
  Quads quads_;
  std::vector<Point> points_;
};

}  // namespace timestep
