// SPDX-License-Identifier: MIT
// Capsule against capsule: the nearest points of the two axes; where these run side by side, both ends of the
// part that they share, and between them only where that is nearer.
//
//   u, v     axes of a and b                                         unit
//   s, t     places on the axes, |s| ≤ half_a, |t| ≤ half_b           m
//   w        c_a − c_b;  the squared distance is ‖w + s u − t v‖²      m
static constexpr wide PARALLEL_SINE = 0.01;  // below this angle places between the ends must be clearly nearer
static constexpr uint LOW_END = 0u, HIGH_END = 1u, CROSSING = 2u;  // features

// Both ends of the common part, and what is nearer than both by more than `slack`. Returns the smallest d, in
// reach or not; NONE where there is no part.
wide add_ends(wide slack, wide reach) {
  wide3 none = wide3(0, 0, 0);
  EdgeLine on_a = {a.c, a.R[1], half_axis(a), none, none}, on_b = {b.c, b.R[1], half_axis(b), none, none};
  int count = side_by_side(on_a, on_b, slack, 1.0e-3 * min(on_a.half_length, on_b.half_length));
  wide lowest = NONE;
  for (int k = 0; k < count; ++k) {
    SidePlace p = side_place(on_a, on_b, k);
    wide d = distance_to_capsule(p, on_b, radius_of(b)) - radius_of(a);
    lowest = min(lowest, d);
    wide3 y_a = p.y - (p.apart - radius_of(a)) * p.n;
    uint feature = p.where == SIDE_LOW ? LOW_END : p.where == SIDE_HIGH ? HIGH_END : CROSSING;
    if (d < reach) add_contact(false, y_a + d * p.n, p.n, d, feature);
  }
  return lowest;
}

void find_contacts(wide reach) {
  wide3 u = a.R[1], v = b.R[1], w = a.c - b.c, across = cross(u, v);
  wide half_a = half_axis(a), half_b = half_axis(b), r_a = radius_of(a), r_b = radius_of(b);
  wide uv = dot(u, v), uw = dot(u, w), vw = dot(v, w), sine2 = dot(across, across);
  bool parallel = sine2 < PARALLEL_SINE * PARALLEL_SINE;

  wide s = sine2 > 1.0e-16 ? clamp((uv * vw - uw) / sine2, -half_a, half_a) : 0.0;
  wide t = clamp(uv * s + vw, -half_b, half_b);
  s = clamp(uv * t - uw, -half_a, half_a);
  wide3 between = w + s * u - t * v;
  wide d = sqrt(dot(between, between)) - r_a - r_b;
  wide slack = 0.5 * preference(d, min(r_a, r_b));
  wide by_ends = add_ends(parallel ? slack : NONE, reach);
  if (parallel && by_ends < NONE) return;
  if (!(d < by_ends - beyond_rounding(1.0e-9) * (r_a + r_b))) return;
  wide3 fallback = parallel ? any_normal(u) : across / sqrt(sine2);
  if (dot(fallback, w) > 0) fallback = -fallback;
  add_round_contact(a.c + s * u, r_a, b.c + t * v, r_b, fallback, reach, CROSSING);
}
