#version 330 core
// A flat symbol that faces the viewer: a marker or a panel. Sizes in pixels.

layout(location = 0) in vec2 corner;
layout(location = 1) in vec4 clip;
layout(location = 2) in vec4 symbol_fill;
layout(location = 3) in vec4 symbol_border;
layout(location = 4) in vec4 form;  // half width, half height, border's width, shape

uniform vec2 half_size;  // of the picture

noperspective out vec2 place;
flat out vec4 fill;
flat out vec4 border;
flat out vec4 symbol;

void main() {
  fill = symbol_fill;
  border = symbol_border;
  symbol = form;
  place = corner * (form.xy + form.z + 2.0);
  gl_Position = vec4(clip.xy + place / half_size * clip.w, clip.zw);
}
