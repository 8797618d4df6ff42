// SPDX-License-Identifier: MIT
// Contacts that last: while two flat bodies hardly move against each other, theirs are those of the last step, a point of
// one over a plane of the other. How far is told from where they were found, so that nothing creeps.
const real KEPT_REACH = real(0.1lf), KEPT_WAY = real(0.05lf);  // d̂

// The other body as the emitter stands, at the start of the step.
void relative_pose(uint emitter, uint other, out real3 place_, out real4 turn) {
  const dvec4 q = pose[emitter].q;
  const dvec3 x = pose[other].c.xyz - pose[emitter].c.xyz;
  place_ = real3(transpose(matrix_of(q)) * x);
  turn = real4(product_d(conjugate_d(q), pose[other].q));
}

// Contacts of pair p were found now, within `reach`.
void see(uint p, real reach) {
  real3 x;
  real4 q;
  relative_pose(pairs[p].emitter, pairs[p].other, x, q);
  pairs[p].seen = real4(x, reach);
  pairs[p].turned = q;
}
