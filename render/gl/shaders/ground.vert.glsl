// SPDX-License-Identifier: MIT
// A quad in the plane of a floor, with all that is the same for every point of it or changes evenly. SHADOWED: shadows may
// fall here, or bodies be near.
layout(location = 0) in vec3 position;
uniform vec4 normal;  // w: offset
uniform vec4 axis_u;  // xyz: unit; w: of the point below the scene's centre
uniform vec4 axis_v;
uniform vec4 grid;    // spacing of the fine grid, its weight, how much the coarse one turns into it, 1 for the first floor
out vec2 at;           // in spacings of the fine grid
out vec2 from_centre;  // in radii of the scene
flat out float fine_weight;
flat out float turning;
flat out vec4 far_bottom;  // what is behind everything: at the lower border of the picture, and how it changes to the upper one
flat out vec4 far_change;
flat out float picture_height;
flat out vec3 sky_part;  // of the floor's colour: what the sky gives, and the sun
#ifdef SHADOWED
flat out vec3 sun_part;
flat out float closeness;  // how much of the sky's part bodies may take
out vec2 shade_at;
out vec3 sun_at;  // sun_place()
flat out vec3 sloping;  // of the floor: sun_slope()
#endif
void main() {
  vec3 n = normal.xyz;
  vec2 place = vec2(dot(position, axis_u.xyz), dot(position, axis_v.xyz));
  at = place / grid.x;
  from_centre = (place - vec2(axis_u.w, axis_v.w)) / frame.centre.w;
  fine_weight = grid.y;
  turning = grid.z;
  far_bottom = frame.background_bottom;
  far_change = frame.background_top - far_bottom;
  picture_height = frame.viewport.y;
  sky_part = frame.floor_color.rgb;
#ifdef SHADOWED
  vec3 sky = ambient(n), sunlight = frame.sun.rgb * max(dot(n, frame.light.xyz), 0.0);
  sun_part = sky_part * (sunlight / (sky + sunlight));
  sky_part *= sky / (sky + sunlight);
  closeness = 0.8 * frame.floor_shade.y * grid.w;
  shade_at = (frame.world_to_floor * vec4(position, 1.0)).xy;
  sun_at = sun_place(position);
  sloping = sun_slope(n);
  // A body that stands here has its far side, which the map shows, where the floor is. The floor itself is not in the map: taken
  // to be a texel farther than it is, it sees no light under edges.
  sun_at.z += 1.0 + 0.5 * (abs(sloping.x) + abs(sloping.y));
#endif
  gl_Position = frame.world_to_clip * vec4(position, 1.0);
}
