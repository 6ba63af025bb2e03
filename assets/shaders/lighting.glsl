// What every surface shares: colours made linear, light, shadow, and back to the screen

uniform vec3 eye;
uniform vec3 toward_light;
uniform mat4 shadow_from_world;
uniform sampler2DShadow shadow_map;
uniform float shadow_texel;  // of the map's side
uniform float shadow_metre;  // a texel's size in the world

// A gamma of 2: close to sRGB, and far cheaper
vec3 to_linear(vec3 srgb) { return srgb * srgb; }
vec3 to_screen(vec3 linear) { return sqrt(linear); }

// The share of the key light that arrives: 1 in the light, 0 in full shadow
float lit_share(vec3 world, vec3 normal) {
  // Step off the surface, so that it does not shade itself
  vec3 at = world + normal * (1.6 * shadow_metre) + toward_light * (0.6 * shadow_metre);
  vec3 p = (shadow_from_world * vec4(at, 1)).xyz;
  if (any(greaterThan(abs(p.xy - 0.5), vec2(0.5)))) return 1.0;

  // Soft edge: five taps, each of them smoothed over four texels
  p.z = min(p.z, 1.0);
  float r = 1.3 * shadow_texel;
  float sum = texture(shadow_map, p);
  sum += texture(shadow_map, p + vec3(r, 0.4 * r, 0));
  sum += texture(shadow_map, p + vec3(-0.4 * r, r, 0));
  sum += texture(shadow_map, p + vec3(-r, -0.4 * r, 0));
  sum += texture(shadow_map, p + vec3(0.4 * r, -r, 0));
  return sum / 5.0;
}

// What arrives from sky and ground, on a surface that looks up by this much, -1 to 1
vec3 ambient_light(float up) {
  return mix(vec3(0.30, 0.285, 0.27), vec3(0.50, 0.54, 0.60), up * 0.5 + 0.5);
}

const vec3 key_light = vec3(0.80, 0.77, 0.72);

// The colour of a matt surface with a little gloss; colours in sRGB
vec3 shade(vec3 srgb, vec3 world, vec3 normal) {
  float facing = dot(normal, toward_light);
  float key = facing > 0.0 ? facing * lit_share(world, normal) : 0.0;
  vec3 half_way = normalize(toward_light + normalize(eye - world));
  float gloss = key * 0.10 * pow(max(dot(normal, half_way), 0.0), 40.0);
  return to_screen(to_linear(srgb) * (ambient_light(normal.y) + key * key_light) + gloss);
}
