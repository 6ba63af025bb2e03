#version 330 core
// A mesh, many times: each instance has its own transform and colour

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 3) in mat4 world_from_mesh;
layout(location = 7) in vec4 instance_color;

uniform mat4 clip_from_world;

out vec3 world_position;
out vec3 world_normal;
out vec3 mesh_position;
flat out vec4 base_color;

void main() {
  // The cofactor matrix turns normals correctly under any scale
  mat3 m = mat3(world_from_mesh);
  mat3 cofactor = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));

  world_normal = cofactor * normal;
  mesh_position = position;
  base_color = instance_color;
  vec4 world = world_from_mesh * vec4(position, 1);
  world_position = world.xyz;
  gl_Position = clip_from_world * world;
}
