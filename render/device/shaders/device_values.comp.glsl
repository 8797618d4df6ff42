// SPDX-License-Identifier: MIT
// A number a body to colour it by, as the last step left it: a thread a body.
//   (none)   speed; m/s
//   ENERGY   kinetic energy, and half of that of each of its contacts; J
// Of who does not move: -infinity.
uniform uint count;

float value_of(uint i, BodyKind k) {
  const real3 v = motion[i].v.xyz;
#ifdef ENERGY
  const real3 in_body = rotate(real4(conjugate_d(unit_d(pose[i].q))), motion[i].omega.xyz);
  const real3 moments = real3(k.J[0] + k.J[1] + k.J[2]) - real3(k.J[0], k.J[1], k.J[2]);
  const real3 L = times_symmetric(moments, -real3(k.J[3], k.J[4], k.J[5]), in_body);
  real twice = real(k.mass) * dot(v, v) + dot(in_body, L);
  for (uint e = end_first[i]; e < end_first[i + 1u]; ++e) twice += grips[ends[e].x >> 1u].z;
  return float(twice / 2);
#else
  return float(sqrt(dot(v, v)));
#endif
}

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= count || counters.overflow != 0u) return;  // of a step that will be made again: those before
  const BodyKind k = kinds[kind_number[i]];
  body_value[i] = k.fixed_ != 0 ? 0xff800000u : floatBitsToUint(value_of(i, k));
}
