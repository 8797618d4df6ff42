// SPDX-License-Identifier: MIT
// What the contacts of the step tell (sim/solver/step_summary.cpp), and what they remember: a thread a contact. To be
// run before the poses move on.
shared dvec4 total[GROUP];
shared uint opening;

void main() {
  const uint k = gl_GlobalInvocationID.x, t = gl_LocalInvocationID.x;
  total[t] = dvec4(0);
  if (t == 0u) opening = 0u;
  barrier();
  if (k < counters.contacts && counters.overflow == 0u) {
    const Contact c = contacts[k];
    const ContactNow s = contact_now(c, place[c.id.x], place[c.id.y]);
    const Push push = normal_push(c, s.d);
    const real limit = grips[k].x, slip = norm(s.u), weight = friction_weight(limit, slip), mu = c.before.w;
    grips[k].w = s.d;
    grips[k].z = 0;
    if (s.d < real(params.d_hat)) {
      grips[k].z = push.value + friction_energy(limit, slip);
      total[t].x = double(grips[k].z);
      atomicAdd(counters.pushing, 1u);
    }
    atomicMax(opening, floatBitsToUint(abs(float(c.n.w))));
    atomicMax(counters.min_gap, ~ordered(float(s.d)));
    if (mu > 0) {
      const real least = real(params.least_load), bound = mu * max(-push.first, least);
      atomicMax(counters.friction_excess, ordered(float(weight * slip / bound - 1)));
      const real pull = real(params.k_t) * slip;
      const real error = abs(min(pull, max(limit, real(0))) - min(pull, mu * -push.first));
      atomicMax(counters.friction_error, ordered(float(error / bound)));
    }
    // What is left of the stretch: all of it while it sticks.
    const real3 stretch = weight / real(params.k_t) * s.u;
#ifdef ROUND
    const bool turns = kinds[kind_number[c.id.x]].rolling == 0;
#else
    const bool turns = true;
#endif
    const dvec4 q = product_d(unit_d(dvec4(place[c.id.x].q)), pose[c.id.x].q);
    const real3 kept = turns ? real3(transpose(matrix_of(q)) * dvec3(stretch)) : stretch;
    kept_stretch[k] = real4(kept, limit > 0 ? 1 : 0);
    kept_feature[k] = c.id.z;
    kept_geometry[k] = raw_geometry[c.id.w];
  }
  barrier();
  for (uint reach = GROUP / 2u; reach > 0u; reach /= 2u) {
    if (t < reach) total[t] += total[t + reach];
    barrier();
  }
  if (t == 0u) {
    part[gl_WorkGroupID.x] = total[0];
    atomicMax(counters.opening, opening);
  }
}
