// SPDX-License-Identifier: MIT
// capsule_capsule.cpp, in the frame of a, where its axis is y: what nearly parallel axes differ by keeps its digits.
// Two ends and what is nearer than both.
#define MOST_FOUND 3
const wide PARALLEL_SINE = wide(0.01lf);

void find_contacts(wide reach) {
  wide2 size_a = size_of(a).xy, size_b = size_of(b).xy;
  wide3 u = wide3(0, 1, 0), v = C[1], c = (b.c - a.c) * a.R;
  wide half_a = wide(0.5lf) * size_a.y, half_b = wide(0.5lf) * size_b.y;
  wide across_w = -(v.x * c.x + v.z * c.z), vw = across_w - v.y * c.y;
  wide sine2 = v.x * v.x + v.z * v.z;
  bool parallel = sine2 < PARALLEL_SINE * PARALLEL_SINE;

  wide s = sine2 > wide(1e-16lf) ? clamp(v.y * across_w / sine2 + c.y, -half_a, half_a) : wide(0.0lf);
  wide t = clamp(v.y * s + vw, -half_b, half_b);
  s = clamp(v.y * t + c.y, -half_a, half_a);
  wide3 between = s * u - t * v - c;
  wide d = sqrt(dot(between, between)) - size_a.x - size_b.x;
  wide slack = parallel ? wide(0.5lf) * preference(d, min(size_a.x, size_b.x)) : NONE;

  // Both ends of the common part.
  EdgeLine on_a = EdgeLine(wide3(0), u, half_a, wide3(0), wide3(0)), on_b = EdgeLine(c, v, half_b, wide3(0), wide3(0));
  int count = side_by_side(on_a, on_b, slack, wide(1e-3lf) * min(half_a, half_b));
  wide by_ends = NONE;
  for (int k = 0; k < count; ++k) {
    SidePlace p = side_place(on_a, on_b, k);
    wide d_end = distance_to_capsule(p, on_b, size_b.x) - size_a.x;
    by_ends = min(by_ends, d_end);
    wide3 y_a = p.y - (p.apart - size_a.x) * p.n;
    uint feature = p.where == SIDE_LOW ? 0u : p.where == SIDE_HIGH ? 1u : 2u;
    if (d_end < reach) add_contact(false, a.c + a.R * (y_a + d_end * p.n), a.R * p.n, d_end, feature);
  }
  if (parallel && by_ends < NONE) return;
  if (!(d < by_ends - beyond_rounding(1e-9lf) * (size_a.x + size_b.x))) return;
  wide3 fallback = parallel ? any_normal(a.R[1]) : a.R * (cross(u, v) / sqrt(sine2));
  if (dot(fallback, b.c - a.c) < 0) fallback = -fallback;
  add_round_contact(false, a.c + s * a.R[1], size_a.x, a.c + a.R * (c + t * v), size_b.x, fallback, reach, 2u);
}
