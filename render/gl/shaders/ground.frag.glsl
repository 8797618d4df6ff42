// SPDX-License-Identifier: MIT
// A studio floor with its grid. SHADOWED: shadows may fall here, or bodies be near; LIVE: in a hurry.
in vec2 at;           // in spacings of the fine grid
in vec2 from_centre;  // in radii of the scene
flat in float fine_weight;
flat in float turning;  // how much the coarse grid turns into the next fine one
flat in vec4 far_bottom;  // what is behind everything: at the lower border of the picture, and how it changes to the upper one
flat in vec4 far_change;
flat in float picture_height;
flat in vec3 sky_part;  // of the floor's colour: what the sky gives, and the sun
#ifdef SHADOWED
flat in vec3 sun_part;
flat in float closeness;  // how much of the sky's part bodies may take
in vec2 shade_at;
in vec3 sun_at;  // sun_place()
flat in vec3 sloping;  // of the floor: sun_slope()
uniform sampler2D floor_map;
#endif
out vec4 fragment;

// Part of a pixel of size `pixel` that lines of the given width cover, along both axes; all in spacings of the lines.
float lines(vec2 place, vec2 pixel, vec2 pixels, float width) {
  vec2 d = abs(fract(place - 0.5) - 0.5);
  vec2 wide = max(vec2(width), pixel);
  vec2 cover = clamp((0.5 * (wide + pixel) - d) * pixels, 0.0, 1.0) * min(width * pixels, 1.0);
  // Where lines come closer than a few pixels: their mean, instead of a moiré.
  cover = mix(cover, vec2(width), smoothstep(0.2, 0.5, pixel));
  return max(cover.x, cover.y);
}

void main() {
  float r = length(from_centre);
  vec2 pixel = max(fwidth(at), vec2(1e-9)), pixels = 1.0 / pixel;

  float near = 1.0 - smoothstep(1.0, 5.5, r);
  const float kFine = 0.30, kCoarse = 0.42;              // how dark they are
  const float kFineWidth = 0.018, kCoarseWidth = 0.003;  // in spacings of their own
  float line = kFine * fine_weight * lines(at, pixel, pixels, kFineWidth);
  line = max(line, mix(kCoarse, kFine, turning) * lines(0.1 * at, 0.1 * pixel, 10.0 * pixels, mix(kCoarseWidth, kFineWidth, turning)));
  if (turning > 0.0) line = max(line, kCoarse * turning * lines(0.01 * at, 0.01 * pixel, 100.0 * pixels, kCoarseWidth));
  line *= near;

  vec3 color = sky_part;
#ifdef SHADOWED
#ifndef LIVE
  color *= 1.0 - closeness * texture(floor_map, shade_at).r;
#endif
  color += sun_part * sun_visibility(sun_at, sloping);
#endif
  color *= 1.0 - line;
  vec4 far = far_bottom + far_change * smoothstep(0.0, 1.0, gl_FragCoord.y / picture_height);
  float fade = smoothstep(1.5, 9.0, r);
  fragment = vec4(mix(color, far.rgb, fade) + min(8.0 * fade, 1.0) * far.a * part_of_level(), 0.0);
}
