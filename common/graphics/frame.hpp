/// @file
/// What every part of the renderer needs to know about the picture being drawn.
#pragma once

#include <glm/glm.hpp>

#include "common/graphics/draw_list.hpp"
#include "common/graphics/shader.hpp"

namespace timestep {

/// Where the light comes from and what it shadows. World frame.
struct Light {
  glm::vec3 toward_light{0, 1, 0};
  glm::vec3 right{1, 0, 0}, up{0, 0, 1};  ///< the shadow map's axes
  glm::vec3 center{0};                    ///< its middle
  glm::vec2 half_size{0};        ///< its extent along the axes [m]; 0 if no shadows
  glm::mat4 clip_from_world{1};  ///< of the shadow map
  float texel = 0;               ///< a shadow map's pixel, share of its side
  float metre = 0;               ///< the same in the world [m]
};

struct Frame {
  CameraPose pose;
  glm::vec3 eye{0};
  glm::mat4 clip_from_world{1};
  glm::vec2 size{0};  ///< pixels
  float scale = 1;    ///< pixels for each pixel of a picture 720 pixels high
  float pixel = 0;    ///< a pixel's size at unit distance
  Light light;
};

/// The light for these things: its shadow map, `side` pixels a side, covers them all,
/// but no more than what the picture shows around the camera's target.
Light light_for(const DrawList& list, const CameraPose& pose, int side);

/// Sets the uniforms of lighting.glsl; the shadow map is on texture unit 1.
void set_lighting(const Shader& shader, const Frame& frame);

}  // namespace timestep
