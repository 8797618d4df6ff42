// SPDX-License-Identifier: MIT
// The largest of the bodies' values that is a number, as its bits; of those ≥ 0, which are in the order of their bits.
layout(std430, binding = DRAW_VALUES) readonly buffer DrawValues { uint body_value[]; };
layout(std430, binding = DRAW_LARGEST) buffer DrawLargest { uint largest; };
shared uint largest_here;

void main() {
  const uint body = gl_GlobalInvocationID.x;
  if (gl_LocalInvocationID.x == 0u) largest_here = 0u;
  barrier();
  if (body < view.counts.x && body_value[body] < 0x7f800000u) atomicMax(largest_here, body_value[body]);
  barrier();
  if (gl_LocalInvocationID.x == 0u && largest_here != 0u) atomicMax(largest, largest_here);
}
