#version 330 core

noperspective in vec2 uv;
flat in vec4 ink;

uniform sampler2D atlas;  // red: the letter; green: a soft halo around it
uniform vec3 halo;
uniform bool halo_pass;   // halos of all letters first, then the letters

out vec4 color;

void main() {
  vec2 cover = texture(atlas, uv).rg;
  color = halo_pass ? vec4(halo, 0.9 * cover.g * ink.a) : vec4(ink.rgb, ink.a * cover.r);
}
