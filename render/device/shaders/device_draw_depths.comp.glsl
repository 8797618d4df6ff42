// SPDX-License-Identifier: MIT
// A level of the greatest depths. A thread a cell.
//   FINEST   from the picture, with SAMPLES a pixel; SEVERAL: more than one
//   (none)   from the level before
#ifdef FINEST
#ifdef SEVERAL
layout(binding = PICTURE_UNIT) uniform sampler2DMS picture;
#else
layout(binding = PICTURE_UNIT) uniform sampler2D picture;
#endif
#else
uniform uint level;
#endif

void main() {
  const uint k = gl_GlobalInvocationID.x;
#ifdef FINEST
  if (k >= cells.x * cells.y) return;
  const uvec2 first = CELL * uvec2(k % cells.x, k / cells.x), end = min(first + CELL, picture_size);
  float depth = 0.0;
  for (uint y = first.y; y < end.y; ++y) {
    for (uint x = first.x; x < end.x; ++x) {
      for (int s = 0; s < SAMPLES; ++s) depth = max(depth, texelFetch(picture, ivec2(x, y), s).r);
    }
  }
  greatest[k] = depth;
#else
  const uvec2 size = cells_of(level), finer = cells_of(level - 1u);
  if (k >= size.x * size.y) return;
  const uvec2 low = 2u * uvec2(k % size.x, k / size.x), high = min(low + 1u, finer - 1u);
  const uint from = first_of(level - 1u);
  greatest[first_of(level) + k] =
      max(max(greatest[from + low.y * finer.x + low.x], greatest[from + low.y * finer.x + high.x]),
          max(greatest[from + high.y * finer.x + low.x], greatest[from + high.y * finer.x + high.x]));
#endif
}
