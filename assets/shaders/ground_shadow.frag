#version 330 core
// Darkens the ground where something stands in the light
#include "lighting.glsl"

in vec3 world_position;

uniform vec3 fade_center;
uniform float reach;

out vec4 color;

void main() {
  vec2 far = (world_position.xz - fade_center.xz) / reach;
  float shadow = 1.0 - lit_share(world_position, vec3(0, 1, 0));
  color = vec4(0.16, 0.22, 0.32, 0.46 * shadow * exp(-9.0 * dot(far, far)));
}
