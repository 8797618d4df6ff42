// SPDX-License-Identifier: MIT
// The grid of the broad phase: a body is in the cell of the middle of its bounds, of the level whose cells are just
// larger than it.

vec3 middle_of(uint i) {
  return (bounds[2u * i].xyz + bounds[2u * i + 1u].xyz) / 2;
}
uint level_at(uint i) {
  return uint(bounds[2u * i].w);
}
float cell_size(uint level) {
  return float(params.cell) * float(1u << level);
}
ivec3 cell_of(vec3 x, uint level) {
  return ivec3(floor(clamp(x / cell_size(level), vec3(-1e9), vec3(1e9))));
}
uint bucket_of(ivec3 cell, uint level) {
  const uvec3 k = uvec3(cell) * uvec3(0x9e3779b1u, 0x85ebca77u, 0xc2b2ae3du);
  uint hash = k.x ^ k.y ^ k.z ^ (level * 0x27d4eb2fu);
  hash ^= hash >> 15;
  hash *= 0x2c1b3c6du;
  hash ^= hash >> 12;
  return hash & (params.buckets - 1u);
}
