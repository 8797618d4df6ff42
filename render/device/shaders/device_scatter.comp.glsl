// SPDX-License-Identifier: MIT
// Bodies into their cells. In any order: lists of pairs are sorted later.
void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= params.bodies) return;
  const uint level = level_at(i);
  if (level + 1u >= LEVELS) return;
  const ivec3 cell = cell_of(middle_of(i), level);
  const uint bucket = bucket_of(cell, level);
  const uint at = cell_first[bucket] + atomicAdd(cursor[bucket], 1u);
  cell_body[at] = uvec4(i | level << 27, cell);
}
