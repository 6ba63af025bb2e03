#version 330 core
// A piece of a line between `a` and `b`, with its neighbours for the joints. Widths and
// lengths in pixels.

layout(location = 0) in vec2 corner;  // x: -1 at a, 1 at b; y: side
layout(location = 1) in vec4 clip_before;
layout(location = 2) in vec4 clip_a;
layout(location = 3) in vec4 clip_b;
layout(location = 4) in vec4 clip_after;
layout(location = 5) in vec4 color_a;
layout(location = 6) in vec4 color_b;
layout(location = 7) in vec4 form_a;  // half width, length so far, dash, gap
layout(location = 8) in vec4 form_b;

uniform vec2 half_size;  // of the picture, in pixels

noperspective out vec4 line_color;
noperspective out vec2 place;  // along and across
noperspective out float half_width;
flat out vec2 dash;

vec2 on_screen(vec4 clip) { return clip.xy / clip.w * half_size; }

vec2 direction(vec2 from, vec2 to, vec2 otherwise) {
  vec2 d = to - from;
  float l = length(d);
  return l > 1e-4 ? d / l : otherwise;
}

void main() {
  vec2 a = on_screen(clip_a);
  vec2 b = on_screen(clip_b);
  vec2 along = direction(a, b, vec2(1, 0));
  bool at_b = corner.x > 0.0;
  vec4 form = at_b ? form_b : form_a;
  vec4 clip = at_b ? clip_b : clip_a;

  // At a joint both pieces end on the line that halves the angle; not at sharp turns
  vec2 other = at_b ? direction(b, on_screen(clip_after), along)
                    : direction(on_screen(clip_before), a, along);
  vec2 across = vec2(-along.y, along.x);
  vec2 tangent = along + other;
  vec2 miter = dot(along, other) > -0.2 ? normalize(vec2(-tangent.y, tangent.x)) : across;
  float reach = corner.y * (form.x + 1.0);
  vec2 offset = miter * (reach / max(dot(miter, across), 0.3));

  // No piece where the line is broken
  bool drawn = form_a.x >= 0.0 && form_b.x >= 0.0;
  place = vec2(form.y + dot(offset, along), reach);
  half_width = form.x;
  dash = form_a.zw;
  line_color = at_b ? color_b : color_a;
  gl_Position = drawn ? vec4(clip.xy + offset / half_size * clip.w, clip.zw)
                      : vec4(2, 2, 2, 1);
}
