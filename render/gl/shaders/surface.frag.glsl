// SPDX-License-Identifier: MIT
// Bodies and glyphs: see surface_pass.cpp. CUBE: soft edges; GLYPH: no shadow falls here; LIVE: in a hurry.
in vec3 world;
in vec3 world_n;
flat in vec4 color;
flat in float shaded;
#ifndef GLYPH
in vec3 local;
#endif
#ifdef CUBE
flat in vec3 face;
flat in vec3 half_size;
flat in vec3 axis_x;
flat in vec3 axis_y;
flat in vec3 axis_z;
#endif
uniform float opacity;
#ifdef TAGGED
flat in float tag;
layout(location = 0, index = 0) out vec4 fragment;
layout(location = 0, index = 1) out vec4 cover;  // its alpha is the opacity
#else
out vec4 fragment;
#endif
void main() {
  vec3 n = normalize(world_n);
  vec3 bent = n;
  float edge = 1.0;
#ifdef CUBE
  // Distance to the neighbouring faces, in metres; the soft edge is never narrower than a pixel, but fades instead.
  float wide = 0.06 * min(half_size.x, min(half_size.y, half_size.z));
  float pixel = frame.viewport.w / gl_FragCoord.w;
  float w = max(wide, 1.2 * pixel);
  vec3 t = clamp(1.0 - half_size * (1.0 - abs(local)) / w, 0.0, 1.0) * (1.0 - face);
  vec3 turn = sign(local) * t * t * (0.55 * wide / w);
  bent = normalize(n + axis_x * turn.x + axis_y * turn.y + axis_z * turn.z);
  edge = 1.0 - 0.22 * max(t.x, max(t.y, t.z)) * sqrt(wide / w);
#endif
  vec3 l = frame.light.xyz;
  float facing = max(dot(bent, l), 0.0);
#ifdef GLYPH
  float sunlit = 1.0;
#else
  float sunlit = sun_visibility(world, n) * smoothstep(0.0, 0.12, dot(n, l));
#endif
  vec3 h = normalize(l + normalize(frame.eye.xyz - world));
  float to_eight = max(dot(bent, h), 0.0);
  to_eight *= to_eight;
  to_eight *= to_eight;
  to_eight *= to_eight;
  float to_sixteen = to_eight * to_eight;
  float highlight = 0.10 * to_sixteen * to_sixteen * to_eight;  // to the 40th
#ifdef LIVE
  vec3 around = ambient(bent);
#else
  vec3 around = ambient(bent) * near_floor(world, n);
#endif
  vec3 albedo = color.rgb;
  float dark = 0.0;  // 1 on the dark fields of a checker
#ifndef GLYPH
  vec3 side = step(vec3(0.0), local);
  dark = shaded > 1.5 ? mod(side.x + side.y + side.z, 2.0) : 0.0;
  albedo *= 1.0 - 0.65 * dark;
#endif
  vec3 lit = albedo * edge * (around + frame.sun.rgb * facing * sunlit) + frame.sun.rgb * highlight * sunlit;
#ifdef TAGGED
  fragment = vec4(mix(color.rgb, lit, min(shaded, 1.0)), tag + dark / 65535.0);
  cover = vec4(color.a * opacity);
#else
  fragment = vec4(mix(color.rgb, lit, min(shaded, 1.0)), color.a * opacity);
#endif
}
