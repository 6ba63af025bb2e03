#version 330 core
// A ball that is small on the picture, as a point: lit by one look at the shadow map

#include "lighting.glsl"

layout(location = 1) in vec4 sphere;  // centre, radius
layout(location = 2) in vec4 ball_color;

uniform mat4 clip_from_world;
uniform float pixel;

flat out vec4 linear_color;
flat out float radius;  // in pixels
flat out float key;

void main() {
  // Smaller than a pixel's half a ball does not get: it gets fainter
  float exact = sphere.w / (pixel * distance(sphere.xyz, eye));
  radius = max(exact, 0.6);
  float share = min(exact / radius, 1.0);
  linear_color = vec4(to_linear(ball_color.rgb), ball_color.a * share * share);

  vec3 top = sphere.xyz + toward_light * sphere.w;
  vec3 p = (shadow_from_world * vec4(top + toward_light * shadow_metre, 1)).xyz;
  key = any(greaterThan(abs(p.xy - 0.5), vec2(0.5)))
            ? 1.0 : textureLod(shadow_map, vec3(p.xy, min(p.z, 1.0)), 0.0);

  gl_PointSize = 2.0 * radius + 1.0;
  gl_Position = clip_from_world * vec4(sphere.xyz, 1);
}
