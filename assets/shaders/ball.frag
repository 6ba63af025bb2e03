#version 330 core
#include "lighting.glsl"

in vec3 on_square;
flat in vec4 ball;
flat in vec4 base_color;

uniform mat4 clip_from_world;
uniform float pixel;

out vec4 color;

void main() {
  // Where the ray comes closest to the centre, and how far inside the edge that is
  vec3 ray = normalize(on_square - eye);
  vec3 from_eye = ball.xyz - eye;
  float along = dot(from_eye, ray);
  vec3 offset = along * ray - from_eye;
  float miss2 = dot(offset, offset);
  float width = pixel * along;
  float cover = clamp((ball.w - sqrt(miss2)) / width + 0.5, 0.0, 1.0);
  if (cover <= 0.0) discard;

  float depth = sqrt(max(ball.w * ball.w - miss2, 0.0));
  vec3 world = eye + (along - depth) * ray;
  vec3 normal = normalize(world - ball.xyz);
  color = vec4(shade(base_color.rgb, world, normal), base_color.a * cover);

  vec4 clip = clip_from_world * vec4(world, 1);
  gl_FragDepth = clip.z / clip.w * 0.5 + 0.5;
}
