// SPDX-License-Identifier: MIT
// The greatest depth in every cell of a picture, from cells of CELL×CELL pixels to one cell: what lies behind the
// cells that it covers is hidden. draw_buffers.h has the same records. std430.
layout(std430, binding = DRAW_DEPTHS) buffer DrawDepths {
  vec4 to_clip[4];            // rows: world to clip space of the picture
  uvec2 picture_size, cells;  // pixels; cells of the finest level
  uint drawn_list;            // which one has been drawn into it
  float greatest[];           // level after level, row after row
};
layout(std430, binding = DRAW_SEEN) buffer DrawSeen {
  uint drawn[4];  // a list: instances that did not wait for its depths
  uint seen[];    // a body, bits: 1 << list, drawn before its depths were; 4 << list, they do not hide it
};

uvec2 cells_of(uint level) { return (cells + (1u << level) - 1u) >> level; }
uint first_of(uint level) {
  uint first = 0u;
  for (uint k = 0u; k < level; ++k) first += cells_of(k).x * cells_of(k).y;
  return first;
}
