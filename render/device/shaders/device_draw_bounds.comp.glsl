// SPDX-License-Identifier: MIT
// What the casters span (CasterBounds of render/gl/frame_uniforms.h). A thread a body.
//
// Floats are kept as bits in their order, lowest ones negated, so that all are maxima of what is 0 at first. Reaches are
// summed up as whole numbers, which the order of adding does not change.
layout(std430, binding = DRAW_BOUNDS) buffer DrawBounds {
  uint edge[10];  // -lowest, highest along the light's axes; the same along the floor's
  uint casters, reach_low, reach_high, pad_;  // the sum is reach_low + 2^16 reach_high
};
shared uint edge_here[10], casters_here, reach_here;

const float REACH_UNITS = 1048576.0;  // of the largest reach that counts

void widen(uint k, float middle, float r) {
  atomicMax(edge_here[k], ordered_bits(r - middle));
  atomicMax(edge_here[k + 1u], ordered_bits(middle + r));
}

void main() {
  const uint t = gl_LocalInvocationID.x;
  if (t < 10u) edge_here[t] = 0u;
  if (t == 0u) {
    casters_here = 0u;
    reach_here = 0u;
  }
  barrier();
  const uint body = gl_GlobalInvocationID.x;
  const uint range = range_of(body), first = range >> 8u, end = first + (range & 255u);
  for (uint k = first; k < end; ++k) {
    const vec3 at = place_of(parts[k], pose[body]);
    const float r = parts[k].reach, size = view.centre.w;
    if (distance(at, view.centre.xyz) - r > view.limits.x * size || r > view.limits.y * size) continue;
    for (uint axis = 0u; axis < 3u; ++axis) widen(2u * axis, dot(view.light[axis].xyz, at), r);
    atomicAdd(casters_here, 1u);
    atomicAdd(reach_here, uint(round(r / (view.limits.y * size) * REACH_UNITS)));
    if (view.limits.w == 0.0 || dot(view.floor_.xyz, at) - view.floor_.w > view.limits.z * r) continue;
    for (uint axis = 0u; axis < 2u; ++axis) widen(6u + 2u * axis, dot(view.across[axis].xyz, at), r);
  }
  barrier();
  if (t < 10u && edge_here[t] != 0u) atomicMax(edge[t], edge_here[t]);
  if (t == 0u && casters_here != 0u) {
    atomicAdd(casters, casters_here);
    atomicAdd(reach_low, reach_here & 0xffffu);
    atomicAdd(reach_high, reach_here >> 16u);
  }
}
