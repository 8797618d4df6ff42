// SPDX-License-Identifier: MIT
// A studio floor with its grid. SHADOWED: shadows may fall here, or bodies be near; LIVE: in a hurry.
in vec3 world;
uniform vec4 normal;  // w: offset
uniform vec4 axis_u;  // xyz: unit; w: of the point below the scene's centre
uniform vec4 axis_v;
uniform vec4 grid;    // spacing of the fine grid, its weight, 1 for the first floor, -
out vec4 fragment;

// Part of a pixel of size `pixel` that lines of the given width every `spacing` metres cover, along both axes.
float lines(vec2 at, vec2 pixel, float spacing, float width) {
  vec2 d = abs(fract(at / spacing - 0.5) - 0.5) * spacing;
  vec2 wide = max(vec2(width), pixel);
  vec2 cover = clamp((0.5 * (wide + pixel) - d) / pixel, 0.0, 1.0) * (width / wide);
  // Where lines come closer than a few pixels: their mean, instead of a moiré.
  cover = mix(cover, vec2(width / spacing), smoothstep(0.2, 0.5, pixel / spacing));
  return max(cover.x, cover.y);
}

void main() {
  vec3 n = normal.xyz;
  vec2 at = vec2(dot(world, axis_u.xyz), dot(world, axis_v.xyz));
  float r = length(at - vec2(axis_u.w, axis_v.w)) / frame.centre.w;
  vec2 pixel = max(fwidth(at), vec2(1e-9));

  float near = 1.0 - smoothstep(1.0, 5.5, r);
  float fine = lines(at, pixel, grid.x, 0.018 * grid.x) * grid.y;
  float coarse = lines(at, pixel, 10.0 * grid.x, 0.03 * grid.x);
  float line = max(0.30 * fine, 0.42 * coarse) * near;

#ifdef SHADOWED
  vec3 sky = ambient(n), sunlight = frame.sun.rgb * max(dot(n, frame.light.xyz), 0.0);
  vec3 lit = sunlight * sun_visibility(world, n);
#ifndef LIVE
  sky *= 1.0 - 0.8 * floor_shade(world) * grid.z;
#endif
  vec3 shade = (sky + lit) / (ambient(n) + sunlight);
#else
  float shade = 1.0;
#endif
  vec3 color = frame.floor_color.rgb * shade * (1.0 - line);
  fragment = vec4(mix(color, background(gl_FragCoord.y), smoothstep(1.5, 9.0, r)), 0.0);
}
