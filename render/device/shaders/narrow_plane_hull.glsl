// SPDX-License-Identifier: MIT
// hull_plane.cpp.
void find_contacts(Placed first, Placed second, double reach) {
  put_first(PLANE, first, second);
  dvec4 plane = shapes[first.shape].size;
  dvec3 n = plane.xyz;
  double centre = dot(n, second.c - first.c) - plane.w;
  if (!(centre - shapes[second.shape].size.x < reach)) return;
  HullView view = view_of(second.shape);
  dvec3 up = n * second.R;
  int count = 0;
  for (uint v = 0u; v < view.vertices; ++v) {
    dvec3 x = vertex_of(view, v);
    double height = centre + dot(up, x);
    if (!(height < reach) || count == MOST_CANDIDATES) continue;
    candidate[count] = x;
    candidate_d[count] = height;
    candidate_name[count] = v;
    ++count;
  }
  int few = choose_spread(count, reach, 1e-6lf * view.inner_radius);
  for (int i = 0; i < few; ++i) {
    int k = chosen[i];
    add_contact(false, second.c + second.R * candidate[k], n, candidate_d[k], candidate_name[k]);
  }
}
