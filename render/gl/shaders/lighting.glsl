// SPDX-License-Identifier: MIT
// How the scene is lit, for both stages. Needs the block Frame; the colours are those of lighting.h.

// What reaches a surface with normal n from everywhere but the sun.
vec3 ambient(vec3 n) { return mix(frame.bounce.rgb, frame.sky.rgb, 0.5 + 0.5 * n.y); }

// Part of it that the floor leaves to a point of a body standing on it: see floor_height(), under_floor().
float near_floor(float height, float under) { return 1.0 - under * exp2(-max(height, 0.0)); }
