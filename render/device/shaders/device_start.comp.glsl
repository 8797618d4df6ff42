// SPDX-License-Identifier: MIT
// First iterate, and friction bounds where the step starts (sim/solver/contact_setup.cpp, friction.cpp).
//   BODIES     a thread a body: its prediction; a body in touch has not fallen
//   CONTACTS   a thread a contact
#ifdef BODIES
void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= params.bodies || counters.overflow != 0u) return;
  const Flight f = flight[i];
  Place at = Place(real4(f.u.xyz, f.W_diag.w), f.q);
  const real h = real(params.h);
  if (f.v.w != 0 && kinds[kind_number[i]].fixed_ == 0)
    at.u.xyz -= h * h * real3(params.gravity[0], params.gravity[1], params.gravity[2]);
  place[i] = at;
  last_step[2u * i] = real4(0, 0, 0, 1);
  last_step[2u * i + 1u] = real4(0, 0, 0, 0);
}
#else
void main() {
  const uint k = gl_GlobalInvocationID.x;
  if (k >= counters.contacts || counters.overflow != 0u) return;
  const Contact c = contacts[k];
  const ContactNow s = contact_now(c, place[c.id.x], place[c.id.y]);
  // One that parts before the first iterate holds nothing back.
  const bool pushes = normal_push(c, s.d).first < 0;
  grips[k] = Grip(pushes ? -c.before.w * normal_push(c, c.n.w).first : 0, 0, 1, 0);
}
#endif
