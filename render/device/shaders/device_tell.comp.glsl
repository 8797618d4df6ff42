// SPDX-License-Identifier: MIT
// What the contacts of the step tell (sim/solver/step_summary.cpp), and what they will remember, in `before`: a thread a
// contact. To be run before the poses move on.
struct Told {
  double energy, stored, rise;
  uint pushing, unsettled, min_gap, force, friction_excess, friction_error, opening;  // as in Counters
};
shared Told told[GROUP];  // of the work group: one atomic for all its contacts

Told together(Told a, Told b) {
  return Told(a.energy + b.energy, a.stored + b.stored, a.rise + b.rise, a.pushing + b.pushing,
              a.unsettled + b.unsettled, max(a.min_gap, b.min_gap), max(a.force, b.force),
              max(a.friction_excess, b.friction_excess), max(a.friction_error, b.friction_error),
              max(a.opening, b.opening));
}

// Energy for the balance of a step that was `solved` or not: see barrier_energy of sim/solver/energy_bound.cpp.
real balanced_energy(Contact c, real d, real limit, real slip, bool solved) {
  const Push push = normal_push(c, d);
  return (!solved && c.r_b.w > 0 ? push.first * (d - c.n.w) : push.value) + friction_energy(limit, slip);
}

void main() {
  const uint k = gl_GlobalInvocationID.x, t = gl_LocalInvocationID.x;
  Told mine = Told(0, 0, 0, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
  if (k < counters.contacts && counters.overflow == 0u) {
    const Contact c = contacts[k];
    const ContactNow s = contact_now(c, place[c.id.x], place[c.id.y]);
    const Push push = normal_push(c, s.d);
    const real limit = grips[k].x, slip = norm(s.u), weight = friction_weight(limit, slip), mu = c.before.w;
    const bool pushes = s.d < real(params.d_hat);
    const real energy = pushes ? push.value + friction_energy(limit, slip) : real(0);
    const real used = min(real(params.k_t) * slip, max(limit, real(0)));
    grips[k] = Grip(limit, used, energy, s.d);
    mine.energy = double(energy);
    mine.pushing = pushes ? 1u : 0u;
    mine.opening = floatBitsToUint(abs(float(c.n.w)));
    mine.min_gap = ~ordered(float(s.d));
    mine.force = pushes ? ordered(float(-push.first)) : 0u;
    if (params.halves != 0u) {
      const bool solved = counters.done != 0u;
      const Place here = Place(real4(0, 0, 0, 0), real4(0, 0, 0, 1));
      mine.stored = double(balanced_energy(c, c.n.w, limit, norm(contact_now(c, here, here).u), solved));
      mine.rise = (pushes || limit > 0 ? double(balanced_energy(c, s.d, limit, slip, solved)) : 0.0lf) - mine.stored;
    }
    if (mu > 0) {
      const real least = real(params.least_load), bound = mu * max(-push.first, least);
      const real error = abs(used - min(real(params.k_t) * slip, mu * -push.first));
      mine.friction_excess = ordered(float(weight * slip / bound - 1));
      mine.friction_error = ordered(float(error / bound));
      const real m_a = place[c.id.x].u.w, m_b = place[c.id.y].u.w;
      const real lighter = m_a > 0 && m_b > 0 ? min(m_a, m_b) : max(m_a, m_b);
      const real law = mu * max(-push.first, real(params.weight_per_mass) * lighter);
      mine.unsettled = error > UNSETTLED * law ? 1u : 0u;
    }
    // What is left of the stretch: all of it while it sticks.
    const real3 stretch = weight / real(params.k_t) * s.u;
#ifdef ROUND
    const bool turns = c.round_.x == 0;
#else
    const bool turns = true;
#endif
    const dvec4 q = product_d(unit_d(dvec4(place[c.id.x].q)), pose[c.id.x].q);
    const real3 kept = turns ? real3(transpose(matrix_of(q)) * dvec3(stretch)) : stretch;
    contacts[k].before.xyz = kept;
  }
  told[t] = mine;
  barrier();
  for (uint reach = GROUP / 2u; reach > 0u; reach /= 2u) {
    if (t < reach) told[t] = together(told[t], told[t + reach]);
    barrier();
  }
  if (t != 0u) return;
  part[gl_WorkGroupID.x] = dvec4(told[0].energy, told[0].stored, told[0].rise, 0);
  atomicAdd(counters.pushing, told[0].pushing);
  atomicAdd(counters.unsettled_contacts, told[0].unsettled);
  atomicMax(counters.min_gap, told[0].min_gap);
  atomicMax(counters.force, told[0].force);
  atomicMax(counters.friction_excess, told[0].friction_excess);
  atomicMax(counters.friction_error, told[0].friction_error);
  atomicMax(counters.opening, told[0].opening);
}
