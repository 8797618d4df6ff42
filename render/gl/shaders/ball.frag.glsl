// SPDX-License-Identifier: MIT
// A pixel of a ball: lit as surface.frag.glsl lights glyphs. See ball.vert.glsl.
flat in vec2 middle;
flat in vec3 round;
flat in vec2 depth;
flat in vec3 to_sun;
flat in vec3 to_shine;
flat in vec3 to_sky;
flat in vec3 to_floor;
flat in float under;
flat in vec3 dim;
flat in vec3 bright;
flat in vec3 sunny;
void main() {
  vec2 p = gl_FragCoord.xy - middle;
  float beyond = 1.0 - (round.x * p.x * p.x + round.y * p.x * p.y + round.z * p.y * p.y);
  if (beyond < 0.0) discard;
  vec3 q = vec3(p, sqrt(beyond));
  vec3 around = (dim + bright * dot(to_sky, q)) * (1.0 - under * (1.0 - dot(to_floor, q)));
  vec3 lit = around + sunny * max(dot(to_sun, q), 0.0) + frame.sun.rgb * highlight_at(dot(to_shine, q));
  gl_FragDepth = depth.x - depth.y * q.z;
  write_color(lit, 0.0);
}
