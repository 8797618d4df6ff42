// SPDX-License-Identifier: MIT
// The contacts at the end of the step for whoever asks, in double and world axes: a thread a contact. To be run before
// device_tell.

// b's surface point, world. Between flat bodies friction acts beside it.
dvec3 surface_of_b(Contact c, dvec3 acts) {
#ifdef ROUND
  if (c.round_.x > 0 || c.round_.y > 0) return acts;
#endif
  const uint b = c.id.y;
  const dvec3 r = matrix_of(pose[b].q) * dvec3(raw_geometry[c.id.w].point.xyz);
  return pose[b].c.xyz + dvec3(place[b].u.xyz) + r + dvec3(rotate_less(place[b].q, real3(r)));
}

void main() {
  const uint k = gl_GlobalInvocationID.x;
  if (k >= counters.contacts || counters.overflow != 0u) return;
  const Contact c = contacts[k];
  const ContactNow s = contact_now(c, place[c.id.x], place[c.id.y]);
  const Push push = normal_push(c, s.d);
  const real limit = grips[k].x, slip = norm(s.u), weight = friction_weight(limit, slip);
  const dvec3 a = pose[c.id.x].c.xyz + dvec3(place[c.id.x].u.xyz);
  ContactTold told;
  told.ends = uvec4(c.id.xy, limit > 0 && real(params.k_t) * slip <= limit ? 1u : 0u, 0u);
  told.y_b = dvec4(surface_of_b(c, a + dvec3(s.y)), double(s.d));
  told.n = dvec4(dvec3(s.n), double(-push.first));
  told.friction = dvec4(dvec3(-weight * s.u), double(c.before.w));
  contact_told[k] = told;
}
