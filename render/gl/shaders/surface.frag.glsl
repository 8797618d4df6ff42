// SPDX-License-Identifier: MIT
// Bodies and glyphs: see surface_pass.cpp. CUBE: soft edges; GLYPH: no shadow falls here; LIVE: in a hurry.
in vec3 to_eye;
in vec3 sun_at;    // sun_place()
in float height;  // above the floor, as near_floor() wants it
#ifdef CUBE
flat in vec3 world_n;
flat in vec4 sunny;  // sun_slope(), and how much of the sun the side may get
#else
in vec3 world_n;
#endif
flat in float shaded;
#if !defined(GLYPH) && !defined(CUBE)
in vec3 local;
#endif
#ifdef CUBE
in vec2 across;        // from the middle of the face, along its two axes; m
flat in vec2 half_face;
flat in vec3 axis_u;
flat in vec3 axis_v;
flat in vec3 constant;  // width of the soft edge in m; under_floor(); 1 on the three sides of a checker that begin dark
#endif
void main() {
#ifdef CUBE
  vec3 n = world_n;
#else
  vec3 n = normalize(world_n);
#endif
  vec3 bent = n;
  float edge = 1.0;
#ifdef CUBE
  // Distance to the neighbouring faces, in metres; the soft edge is never narrower than a pixel, but fades instead.
  float wide = constant.x;
  float pixel = frame.viewport.w / gl_FragCoord.w;
  float w = max(wide, 1.2 * pixel);
  float part = wide / w;
  vec2 t = clamp(1.0 - (half_face - abs(across)) / w, 0.0, 1.0);
  vec2 turn = sign(across) * t * t * (0.55 * part);
  bent = normalize(n + axis_u * turn.x + axis_v * turn.y);
  edge = 1.0 - 0.22 * max(t.x, t.y) * sqrt(part);
#endif
  vec3 l = frame.light.xyz;
  float facing = max(dot(bent, l), 0.0);
#ifdef GLYPH
  float sunlit = 1.0;
#elif defined(CUBE)
  float sunlit = sun_visibility(sun_at, sunny.xyz) * sunny.w;
#else
  float sunlit = sun_visibility(sun_at, sun_slope(n)) * smoothstep(0.0, 0.12, dot(n, l));
#endif
  vec3 h = normalize(l + normalize(to_eye));
  float highlight = highlight_at(dot(bent, h));
#ifdef LIVE
  vec3 around = ambient(bent);
#elif defined(CUBE)
  vec3 around = ambient(bent) * near_floor(height, constant.y);
#else
  vec3 around = ambient(bent) * near_floor(height, under_floor(n));
#endif
  vec3 albedo = color.rgb;
  float dark = 0.0;
#ifndef GLYPH
#ifdef CUBE
  vec3 side = vec3(step(vec2(0.0), across), constant.z);
#else
  vec3 side = step(vec3(0.0), local);
#endif
  dark = shaded > 1.5 ? mod(side.x + side.y + side.z, 2.0) : 0.0;
  albedo *= 1.0 - 0.65 * dark;
#endif
  vec3 lit = albedo * edge * (around + frame.sun.rgb * facing * sunlit) + frame.sun.rgb * highlight * sunlit;
  write_color(mix(color.rgb, lit, min(shaded, 1.0)), dark);
}
