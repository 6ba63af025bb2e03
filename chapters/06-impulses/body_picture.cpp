#include "chapters/06-impulses/body_picture.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {

Color body_color(std::size_t index) {
  static constexpr std::array<Color, 4> k_colors{{{0.36F, 0.62F, 0.80F, 1},
                                                  {0.93F, 0.69F, 0.36F, 1},
                                                  {0.55F, 0.76F, 0.62F, 1},
                                                  {0.83F, 0.62F, 0.75F, 1}}};
  return k_colors[index % k_colors.size()];
}

glm::mat4 placed(const glm::vec3& at, const glm::quat& q, float scale) {
  glm::mat4 world_from_body = scale * glm::mat4_cast(q);
  world_from_body[3] = glm::vec4(at, 1);
  return world_from_body;
}

void draw_shape(DrawList& list, const Shape& shape, const glm::mat4& world_from_body,
                const Color& color) {
  const auto add = [&](ShapeKind kind, const glm::mat4& body_from_unit) {
    list.shapes.push_back({kind, world_from_body * body_from_unit, color});
  };
  const auto scaled = [](const glm::vec3& by) { return glm::scale(glm::mat4(1), by); };
  if (const auto* ball = std::get_if<Sphere>(&shape)) {
    add(ShapeKind::sphere, scaled(glm::vec3(float(ball->radius))));
  } else if (const auto* box = std::get_if<Box>(&shape)) {
    add(ShapeKind::box, scaled(glm::vec3(box->half_extents)));
  } else if (const auto* cylinder = std::get_if<Cylinder>(&shape)) {
    // The picture's cylinder stands on y; a quarter turn lays it along z
    const float r = float(cylinder->radius), half = float(cylinder->height) / 2;
    add(ShapeKind::cylinder,
        glm::rotate(glm::mat4(1), glm::radians(90.0F), glm::vec3(1, 0, 0))
            * scaled(glm::vec3(r, half, r)));
  }
}

void draw_rings(DrawList& list, float radius, const glm::mat4& world_from_body,
                const Color& color) {
  constexpr int k_pieces = 32;
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    std::vector<glm::vec3> ring;
    for (int i = 0; i <= k_pieces; ++i) {
      const float angle =
          2 * std::numbers::pi_v<float> * static_cast<float>(i) / k_pieces;
      glm::vec4 p(0, 0, 0, 1);
      p[(axis + 1) % 3] = 1.01F * radius * std::cos(angle);
      p[(axis + 2) % 3] = 1.01F * radius * std::sin(angle);
      ring.emplace_back(world_from_body * p);
    }
    list.lines.push_back({.points = ring, .color = color, .width = 2});
  }
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
