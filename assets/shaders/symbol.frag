#version 330 core

noperspective in vec2 place;
flat in vec4 fill;
flat in vec4 border;
flat in vec4 symbol;

out vec4 color;

float box(vec2 p, vec2 half_size) {
  vec2 q = abs(p) - half_size;
  return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0);
}

float plus(vec2 p, float r) {
  return min(box(p, vec2(r, 0.30 * r)), box(p, vec2(0.30 * r, r)));
}

float triangle(vec2 p, float r) {
  p.y += 0.25 * r;
  p.x = abs(p.x);
  return max(dot(p, vec2(0.866, 0.5)), -p.y) - 0.55 * r;
}

float star(vec2 p, float r) {
  const vec2 k1 = vec2(0.809017, -0.587785);
  const vec2 k2 = vec2(-0.809017, -0.587785);
  p.x = abs(p.x);
  p -= 2.0 * max(dot(k1, p), 0.0) * k1;
  p -= 2.0 * max(dot(k2, p), 0.0) * k2;
  p = vec2(abs(p.x), p.y - r);
  vec2 edge = 0.45 * vec2(-k1.y, k1.x) - vec2(0, 1);
  float h = clamp(dot(p, edge) / dot(edge, edge), 0.0, r);
  return length(p - edge * h) * sign(p.y * edge.x - p.x * edge.y);
}

// How far outside the shape's outline a place is, in pixels; the shapes' areas look alike
float outside(int shape, vec2 p, vec2 half_size) {
  float r = half_size.x;
  switch (shape) {
    case 0: return length(p) - 0.85 * r;
    case 1: return box(p, vec2(0.74 * r));
    case 2: return triangle(p, r);
    case 3: return (abs(p.x) + abs(p.y) - r) * 0.7071;
    case 4: return plus(vec2(p.x + p.y, p.y - p.x) * 0.7071, 0.98 * r);
    case 5: return plus(p, 0.98 * r);
    case 6: return star(p, 1.1 * r);
    case 7: return abs(length(p) - 0.66 * r) - 0.22 * r;
  }
  return box(p, half_size - 5.0) - 5.0;
}

void main() {
  float d = outside(int(symbol.w + 0.5), place, symbol.xy);
  float inner = clamp(0.5 - d, 0.0, 1.0);
  float outer = clamp(0.5 + symbol.z - d, 0.0, 1.0);
  if (outer <= 0.0) discard;
  float alpha = mix(border.a * outer, fill.a, inner);
  color = vec4(mix(border.rgb, fill.rgb, inner), alpha);
}
