#version 330 core

in vec3 direction;

out vec4 color;

void main() {
  float height = normalize(direction).y;
  vec3 horizon = vec3(0.958, 0.966, 0.976);
  vec3 sky = vec3(0.80, 0.87, 0.935);
  vec3 below = vec3(0.915, 0.928, 0.942);
  color = vec4(height > 0.0 ? mix(horizon, sky, smoothstep(0.0, 0.55, height))
                            : mix(horizon, below, smoothstep(0.0, 0.5, -height)),
               1);
}
