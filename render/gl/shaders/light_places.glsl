// SPDX-License-Identifier: MIT
// Where a point is in the shadow map and above the floor, and how a surface lies there; for both stages, as vertices can tell
// what changes evenly, and all of what is flat. Software GL reads a varying faster than it multiplies by a matrix of the block.
// Needs the block Frame.

vec3 sun_place(vec3 p) { return (frame.world_to_shadow * vec4(p, 1.0)).xyz; }

// Of a surface with normal n: how much deeper it gets from texel to texel along x and y; and below 0 if it faces the sun.
vec3 sun_slope(vec3 n) {
  vec3 m = mat3(frame.world_to_shadow) * n;
  return vec3(clamp(-m.xy / min(m.z, -0.1 * length(m)), -4.0, 4.0), m.z);
}

vec3 floor_up() { return vec3(frame.world_to_floor[0].z, frame.world_to_floor[1].z, frame.world_to_floor[2].z); }

// Of a point above the floor, in lengths over which what near_floor() does halves.
float floor_height(vec3 p) {
  return (dot(floor_up(), p) + frame.world_to_floor[3].z) * (1.442695 / 0.8 / frame.floor_shade.x);
}

// Part of the surroundings of a surface with normal n that the floor is, where it touches it.
float under_floor(vec3 n) { return 0.35 * frame.floor_shade.y * (1.0 - dot(n, floor_up())); }
