// SPDX-License-Identifier: MIT
// Two round things: spheres of radius r_a and r_b about p_a and p_b. `fallback`: the unit normal where p_a = p_b.
void add_round_contact(wide3 p_a, wide r_a, wide3 p_b, wide r_b, wide3 fallback, wide reach, uint feature) {
  wide3 between = p_b - p_a;
  wide apart = sqrt(dot(between, between));
  wide d = apart - r_a - r_b;
  if (!(d < reach)) return;
  bool is_defined = apart > beyond_rounding(1.0e-12) * (r_a + r_b) && apart > 0;
  wide3 n = is_defined ? between / apart : fallback;
  add_contact(false, p_b - r_b * n, n, d, feature);
}
