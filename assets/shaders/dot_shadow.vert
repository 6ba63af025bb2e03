#version 330 core
// A ball as the light sees it, as a point

layout(location = 1) in vec4 sphere;

uniform mat4 clip_from_world;
uniform float shadow_metre;

void main() {
  gl_PointSize = max(2.0 * sphere.w / shadow_metre, 1.0);
  gl_Position = clip_from_world * vec4(sphere.xyz, 1);
}
