// SPDX-License-Identifier: MIT
// capsule_capsule.cpp.
const double PARALLEL_SINE = 0.01lf;

// Both ends of the common part. Returns the smallest d.
double add_ends(Placed a, Placed b, dvec2 size_a, dvec2 size_b, double slack, double reach) {
  EdgeLine on_a = EdgeLine(a.c, a.R[1], 0.5lf * size_a.y, dvec3(0), dvec3(0));
  EdgeLine on_b = EdgeLine(b.c, b.R[1], 0.5lf * size_b.y, dvec3(0), dvec3(0));
  int count = side_by_side(on_a, on_b, slack, 1e-3lf * min(on_a.half_length, on_b.half_length));
  double lowest = NONE;
  for (int k = 0; k < count; ++k) {
    SidePlace p = side_place[k];
    double d = distance_to_capsule(p, on_b, size_b.x) - size_a.x;
    lowest = min(lowest, d);
    dvec3 y_a = p.y - (p.apart - size_a.x) * p.n;
    uint feature = p.where == SIDE_LOW ? 0u : p.where == SIDE_HIGH ? 1u : 2u;
    if (d < reach) add_contact(false, y_a + d * p.n, p.n, d, feature);
  }
  return lowest;
}

void find_contacts(Placed first, Placed second, double reach) {
  begin_contacts();
  dvec2 size_a = shapes[first.shape].size.xy, size_b = shapes[second.shape].size.xy;
  dvec3 u = first.R[1], v = second.R[1], w = first.c - second.c;
  double half_a = 0.5lf * size_a.y, half_b = 0.5lf * size_b.y;
  double uv = dot(u, v), uw = dot(u, w), vw = dot(v, w);
  dvec3 across = cross(u, v);
  double sine2 = dot(across, across);
  bool parallel = sine2 < PARALLEL_SINE * PARALLEL_SINE;

  double s = sine2 > 1e-16lf ? clamp((uv * vw - uw) / sine2, -half_a, half_a) : 0.0lf;
  double t = clamp(uv * s + vw, -half_b, half_b);
  s = clamp(uv * t - uw, -half_a, half_a);
  dvec3 between = w + s * u - t * v;
  double d = sqrt(dot(between, between)) - size_a.x - size_b.x;
  double slack = 0.5lf * preference(d, min(size_a.x, size_b.x));
  double by_ends = add_ends(first, second, size_a, size_b, parallel ? slack : NONE, reach);
  if (parallel && by_ends < NONE) return;
  if (!(d < by_ends - 1e-9lf * (size_a.x + size_b.x))) return;
  dvec3 fallback = parallel ? any_normal(u) : across / sqrt(sine2);
  if (dot(fallback, w) > 0) fallback = -fallback;
  add_round_contact(false, first.c + s * u, size_a.x, second.c + t * v, size_b.x, fallback, reach, 2u);
}
