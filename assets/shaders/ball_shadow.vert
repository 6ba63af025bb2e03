#version 330 core
// A ball as the light sees it: a square with the ball's disc in it

layout(location = 0) in vec2 corner;
layout(location = 1) in vec4 sphere;

uniform mat4 clip_from_world;
uniform vec3 right;
uniform vec3 up;

out vec2 place;

void main() {
  place = corner;
  vec3 world = sphere.xyz + sphere.w * (corner.x * right + corner.y * up);
  gl_Position = clip_from_world * vec4(world, 1);
}
