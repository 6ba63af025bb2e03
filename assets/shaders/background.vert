#version 330 core
// A square over the whole picture, behind everything

layout(location = 0) in vec2 corner;

uniform mat4 world_from_clip;

out vec3 direction;

void main() {
  vec4 near = world_from_clip * vec4(corner, -1, 1);
  vec4 far = world_from_clip * vec4(corner, 1, 1);
  direction = far.xyz / far.w - near.xyz / near.w;
  gl_Position = vec4(corner, 1, 1);
}
