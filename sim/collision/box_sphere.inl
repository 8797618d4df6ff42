// SPDX-License-Identifier: MIT
// Sphere b against box a, in the frame of the box, which owns the normal.
//
//   p   centre of the sphere     m
//   q   point of the box nearest to p; p = q means that the centre is inside, and the nearest face decides
void find_contacts(wide reach) {
  wide3 h = half_edges(a), p = (b.c - a.c) * a.R, q = clamp(p, -h, h), gap = p - q, n = a.R[0];
  wide apart = sqrt(dot(gap, gap)), radius = radius_of(b);
  if (apart > beyond_rounding(1.0e-9) * smallest_half(a)) {
    n = a.R * (gap / apart);
  } else {
    wide3 depth = abs(p) - h;
    int axis = largest_axis(depth);
    apart = at(depth, axis);
    n = sign_of(at(p, axis)) * column(a.R, axis);
  }
  wide d = apart - radius;
  if (d < reach) add_contact(false, b.c - radius * n, n, d, 0u);
}
