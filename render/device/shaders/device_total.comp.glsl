// SPDX-License-Identifier: MIT
// The work groups' sums, added in order by one work group. CONTACTS: elastic energy; BODIES, after it: kinetic and
// potential energy, and whether the step counts.
uniform uint count;
shared dvec4 total[GROUP];

void main() {
  const uint t = gl_LocalInvocationID.x;
  dvec4 sum = dvec4(0);
  for (uint k = t; k < count; k += GROUP) sum += part[k];
  total[t] = sum;
  barrier();
  for (uint reach = GROUP / 2u; reach > 0u; reach /= 2u) {
    if (t < reach) total[t] += total[t + reach];
    barrier();
  }
  if (t != 0u || counters.overflow != 0u) return;
#ifdef BODIES
  counters.kinetic = total[0].x;
  counters.potential = total[0].y;
  counters.gained = total[0].z;
  counters.rise += total[0].z + total[0].w;
  if (ran_away()) ++counters.bad;
  if (params.halves != 0u && ends_unsolved()) counters.overflow |= ENDED_UNSOLVED;
#else
  counters.elastic = total[0].x;
  counters.stored = total[0].y;
  counters.rise = total[0].z;
#endif
}
