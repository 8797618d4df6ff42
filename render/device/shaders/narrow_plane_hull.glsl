// SPDX-License-Identifier: MIT
// hull_plane.cpp.

void find_contacts(wide reach) {
  wide4 plane = size_of(a);
  wide3 n = plane.xyz;
  wide centre = dot(n, b.c - a.c);
  if (!(centre - size_of(b).x < reach)) return;
  TextHull view = view_of(b.shape);
  wide3 up = n * b.R;
  int count = 0;
#ifdef SOLIDS
  // side_on_plane of round_sides.cpp: the first corner of either end is the lowest.
  bool on_side = is_solid(b.shape) && !(1 - up.y * up.y < wide(ROUND_SIDE * ROUND_SIDE));
#endif
  for (uint v = 0u; v < view.vertices; ++v) {
#ifdef SOLIDS
    if (on_side && v % FACETS != 0u) continue;
#endif
    wide3 x = vertex_of(view, v);
    wide height = centre + dot(up, x);
    if (!(height < reach) || count == MOST_CANDIDATES) continue;
    candidate[count] = x;
    candidate_d[count] = height;
    candidate_name[count] = v;
    ++count;
  }
  int few = choose_spread(count, reach, beyond_rounding(1e-6lf) * view.inner_radius);
  for (int i = 0; i < few; ++i) {
    int k = chosen[i];
    add_contact(false, b.c + b.R * candidate[k], n, candidate_d[k], candidate_name[k]);
  }
}
