/// @file
/// Between the world, clip space and the picture's pixels.
#pragma once

#include <cmath>

#include <glm/glm.hpp>

#include "common/graphics/frame.hpp"

namespace timestep {

inline bool is_finite(const glm::vec4& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)
         && std::isfinite(v.w);
}

/// Clip space at a pixel, in front of everything; pixels from the top left corner.
inline glm::vec4 clip_from_pixel(const Frame& frame, glm::vec2 pixel) {
  const glm::vec2 share = pixel / frame.size * 2.0F - 1.0F;
  return {share.x, -share.y, 0, 1};
}

inline glm::vec2 pixel_from_clip(const Frame& frame, const glm::vec4& clip) {
  return glm::vec2(clip.x / clip.w + 1, 1 - clip.y / clip.w) * frame.size / 2.0F;
}

/// Clip space of a place in the world, with the depth of one nearer to the eye by a
/// share of its distance: what lies on a surface then shows.
inline glm::vec4 toward_eye(const Frame& frame, glm::vec3 world, float share) {
  glm::vec4 clip = frame.clip_from_world * glm::vec4(world, 1);
  const glm::vec3 nearer = world + (frame.eye - world) * share;
  const glm::vec4 front = frame.clip_from_world * glm::vec4(nearer, 1);
  if (front.w > 0) clip.z = front.z / front.w * clip.w;
  return clip;
}

}  // namespace timestep
