#version 330 core

noperspective in vec4 line_color;
noperspective in vec2 place;
noperspective in float half_width;
flat in vec2 dash;  // length drawn, length left out; none if the second is 0

out vec4 color;

void main() {
  // How far outside the stroke this pixel is; dashes have round ends
  float period = dash.x + dash.y;
  float beyond = 0.0;
  if (dash.y > 0.0) {
    beyond = max(abs(mod(place.x, period) - 0.5 * period) - 0.5 * dash.x, 0.0);
  }
  float outside = length(vec2(beyond, place.y)) - half_width;
  float cover = clamp(0.5 - outside, 0.0, 1.0);
  if (cover <= 0.0) discard;
  color = vec4(line_color.rgb, line_color.a * cover);
}
