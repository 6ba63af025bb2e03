#version 330 core
// A mesh at a transform, seen by a camera: the least that a model's shader needs

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texture_coordinates;

uniform mat4 projection;
uniform mat4 view;
uniform mat4 world_from_model;

out vec3 world_normal;
out vec2 uv;

void main() {
  world_normal = mat3(world_from_model) * normal;
  uv = texture_coordinates;
  gl_Position = projection * view * world_from_model * vec4(position, 1);
}
