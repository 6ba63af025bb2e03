#version 330 core
// A ball as a square that faces the eye and is just large enough to cover it

layout(location = 0) in vec2 corner;
layout(location = 1) in vec4 sphere;  // centre, radius
layout(location = 2) in vec4 ball_color;

uniform mat4 clip_from_world;
uniform vec3 eye;
uniform float pixel;  // of the picture, as the tangent of its angle

out vec3 on_square;
flat out vec4 ball;
flat out vec4 base_color;

void main() {
  vec3 away = sphere.xyz - eye;
  float distance = length(away);
  vec3 forward = away / distance;
  vec3 right = normalize(cross(forward, abs(forward.y) < 0.99 ? vec3(0, 1, 0)
                                                              : vec3(1, 0, 0)));
  vec3 up = cross(right, forward);

  // The silhouette's circle seen from nearby is larger than the ball; a pixel for its edge
  float radius = sphere.w;
  float grown = radius * distance
                / sqrt(max(distance * distance - radius * radius, 1e-3 * radius * radius));
  grown += pixel * distance;
  on_square = sphere.xyz + grown * (corner.x * right + corner.y * up);
  ball = sphere;
  base_color = ball_color;
  gl_Position = clip_from_world * vec4(on_square, 1);
}
