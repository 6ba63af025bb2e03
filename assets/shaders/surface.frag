#version 330 core
#include "lighting.glsl"

in vec3 world_position;
in vec3 world_normal;
in vec3 mesh_position;
flat in vec4 base_color;

uniform float pattern;  // 1: octants in two tones, so that a round body's turning shows

out vec4 color;

void main() {
  vec3 sides = clamp(mesh_position / max(fwidth(mesh_position), 1e-6), -1.0, 1.0);
  float octant = sides.x * sides.y * sides.z;
  vec3 srgb = base_color.rgb * (1.0 + 0.10 * pattern * (octant - 1.0));

  vec3 normal = normalize(world_normal);
  if (!gl_FrontFacing) normal = -normal;
  color = vec4(shade(srgb, world_position, normal), base_color.a);
}
