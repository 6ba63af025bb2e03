/// @file
/// Bodies as a draw list shows them.
#pragma once

#include "common/graphics/draw_list.hpp"
#include "common/physics/shapes.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {

/// Colours of bodies that a scene tells apart, by turns.
Color body_color(std::size_t index);

/// World from body, the body `scale` times as large.
glm::mat4 placed(const glm::vec3& at, const glm::quat& q, float scale);

/// A ball, box or cylinder; nothing for other shapes.
void draw_shape(DrawList& list, const Shape& shape, const glm::mat4& world_from_body,
                const Color& color);

/// Three circles around a ball, about its axes.
void draw_rings(DrawList& list, float radius, const glm::mat4& world_from_body,
                const Color& color);

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
