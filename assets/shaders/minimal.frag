#version 330 core
// Light from above, on the material's colour

in vec3 world_normal;
in vec2 uv;

uniform vec4 diffuse;
uniform bool has_map;
uniform sampler2D diffuse_map;

out vec4 color;

void main() {
  vec4 surface = has_map ? diffuse * texture(diffuse_map, uv) : diffuse;
  float light = 0.7 + 0.3 * normalize(world_normal).y;
  color = vec4(surface.rgb * light, surface.a);
}
