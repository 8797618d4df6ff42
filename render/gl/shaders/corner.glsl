// SPDX-License-Identifier: MIT
// corner() of this vertex, in clip coordinates: one triangle that covers the viewport, which is −1 … 1 in both.
vec2 corner() { return vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1); }
