// SPDX-License-Identifier: MIT
// Where between two bodies friction acts (sim/bond/contact_bond.h, sim/solver/contact_setup.h).

// Between their surfaces where they touch; start_d: where the step starts.
double touching_gap(double start_d) { return clamp(start_d, 0.0lf, double(params.d_hat)); }

// What of it lies between b's surface and where friction acts.
double gap_beside_b(double gap, uint a, uint b) {
  if (kinds[kind_number[a]].fixed_ != 0) return 0;
  return kinds[kind_number[b]].fixed_ != 0 ? gap : gap / 2;
}
