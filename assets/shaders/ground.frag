#version 330 core

in vec3 world_position;

uniform vec3 fade_center;
uniform float reach;       // where the ground has faded into the sky
uniform float cell;        // the main lines' distance: a power of ten, in metres
uniform float fine_share;  // how strongly the lines at a tenth of it show, 0 to 1

out vec4 color;

// How much of a pixel a line takes; lines are `spacing` apart and a pixel wide
float line(vec2 place, vec2 pixel, float spacing) {
  vec2 p = place / spacing;
  vec2 width = pixel / spacing;
  vec2 distance = abs(fract(p - 0.5) - 0.5) / width;
  vec2 cover = clamp(1.1 - distance, 0.0, 1.0);
  // Lines closer than a few pixels would only flicker
  cover *= clamp(1.0 - width * 4.0, 0.0, 1.0);
  return max(cover.x, cover.y);
}

void main() {
  vec2 place = world_position.xz;
  vec2 far = (place - fade_center.xz) / reach;
  float share = exp(-9.0 * dot(far, far));

  vec2 pixel = max(fwidth(place), 1e-9);
  float ink = 0.12 * fine_share * line(place, pixel, cell * 0.1);
  ink = max(ink, 0.26 * line(place, pixel, cell));
  ink = max(ink, 0.42 * line(place, pixel, cell * 10.0));
  color = vec4(mix(vec3(0.925, 0.935, 0.945), vec3(0.45, 0.52, 0.60), ink), share);
}
