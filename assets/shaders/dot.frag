#version 330 core
#include "lighting.glsl"

flat in vec4 linear_color;
flat in float radius;
flat in float key;

uniform vec3 light_in_view;  // toward the light
uniform vec3 up_in_view;

out vec4 color;

void main() {
  vec2 place = (gl_PointCoord - 0.5) * (2.0 * radius + 1.0);
  float cover = clamp(radius - length(place) + 0.5, 0.0, 1.0);
  if (cover <= 0.0) discard;

  // The view frame's y runs up
  vec2 across = vec2(place.x, -place.y) / radius;
  vec3 normal = vec3(across, sqrt(max(1.0 - dot(across, across), 0.0)));
  float facing = max(dot(normal, light_in_view), 0.0);
  vec3 light = ambient_light(dot(normal, up_in_view)) + key * facing * key_light;
  color = vec4(to_screen(linear_color.rgb * light), linear_color.a * cover);
}
