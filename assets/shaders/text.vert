#version 330 core
// A letter at a place in the picture, in pixels from its top left corner

layout(location = 0) in vec2 corner;
layout(location = 1) in vec4 rectangle;  // left, top, width, height
layout(location = 2) in vec4 source;     // the same in the atlas
layout(location = 3) in vec4 letter_color;

uniform vec2 half_size;
uniform float atlas_side;

noperspective out vec2 uv;
flat out vec4 ink;

void main() {
  vec2 part = corner * 0.5 + 0.5;
  uv = (source.xy + part * source.zw) / atlas_side;
  ink = letter_color;
  vec2 ndc = (rectangle.xy + part * rectangle.zw) / half_size - 1.0;
  gl_Position = vec4(ndc.x, -ndc.y, 0, 1);
}
