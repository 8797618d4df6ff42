// SPDX-License-Identifier: MIT
// The bodies whose bounding balls a ray may meet, in any order, with their poses: a thread a body. What of them it meets
// is looked at by the processor (sim/collision/ray_cast.h). Needs device_draw_pose.
layout(local_size_x = GROUP) in;

struct Met {
  uvec4 body;
  Pose at;
};
layout(std430, binding = DRAW_REACHES) readonly buffer DrawReaches { float reach[]; };  // radius, rounded up; inf: a plane
layout(std430, binding = DRAW_RAY) readonly buffer DrawRay {
  dvec4 origin, direction;  // unit
  uint bodies, room;
};
layout(std430, binding = DRAW_MET) buffer DrawMet {
  uint count, pad_[7];
  Met met[];
};

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= bodies) return;
  const Pose at = pose[i];
  const dvec3 between = origin.xyz - at.c.xyz;
  const double b = dot(between, direction.xyz), r = double(reach[i]);
  const dvec3 apart = between - b * direction.xyz;
  if (!isinf(reach[i]) && (dot(apart, apart) > r * r * 1.000001lf || b > r * 1.000001lf)) return;
  const uint k = atomicAdd(count, 1u);
  if (k < room) met[k] = Met(uvec4(i, 0u, 0u, 0u), at);
}
