#version 330 core
// A parallelogram on the ground

layout(location = 0) in vec2 corner;

uniform mat4 clip_from_world;
uniform vec3 center;
uniform vec3 side;
uniform vec3 other_side;

out vec3 world_position;

void main() {
  world_position = center + corner.x * side + corner.y * other_side;
  gl_Position = clip_from_world * vec4(world_position, 1);
}
